package org.toqa.camera;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.camera.PictureAnswer.Away;
import org.toqa.camera.PictureAnswer.Reason;
import org.toqa.camera.PictureAnswer.Shown;

/** Pictures of cameras that answer as they should, and of such that do not. */
class CamerasTest {
  private static final byte[] JPEG = {
    (byte) 0xFF, (byte) 0xD8, (byte) 0xFF, (byte) 0xE0, 1, 2, 3, (byte) 0xFF, (byte) 0xD9
  };

  private final AtomicInteger asked = new AtomicInteger();
  private final CountDownLatch end = new CountDownLatch(1);
  private HttpServer device;
  private Cameras cameras;

  @BeforeEach
  void start() throws IOException {
    device = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    device.setExecutor(Executors.newVirtualThreadPerTaskExecutor());
    device.start();
    cameras = new Cameras(new NoCameras());
  }

  @AfterEach
  void stop() throws IOException {
    end.countDown();
    cameras.close();
    device.stop(0);
  }

  private static final class NoCameras implements CameraStore {
    @Override
    public List<Camera> cameras() {
      return List.of();
    }

    @Override
    public Camera add(CameraOrder order, String by) {
      throw new UnsupportedOperationException();
    }

    @Override
    public boolean change(Camera camera, String by) {
      return false;
    }

    @Override
    public boolean delete(long id, String by) {
      return false;
    }
  }

  private void serve(int status, String type, byte[] body) {
    device.createContext(
        "/",
        exchange -> {
          try (exchange) {
            asked.incrementAndGet();
            exchange.getResponseHeaders().set("Content-Type", type);
            exchange.getResponseHeaders().set("Location", "/elsewhere");
            exchange.sendResponseHeaders(status, body.length == 0 ? -1 : body.length);
            exchange.getResponseBody().write(body);
          }
        });
  }

  /** A stream that goes on until the test ends. */
  private void stream(String headers) {
    device.createContext(
        "/",
        exchange -> {
          exchange.getResponseHeaders().set("Content-Type", "multipart/x-mixed-replace;boundary=b");
          exchange.sendResponseHeaders(200, 0);
          OutputStream body = exchange.getResponseBody();
          body.write(("--b\r\n" + headers + "\r\n").getBytes(StandardCharsets.US_ASCII));
          body.write(JPEG);
          body.flush();
          try {
            end.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
          exchange.close();
        });
  }

  private Camera camera(String path) {
    URI url = URI.create("http://127.0.0.1:%d%s".formatted(device.getAddress().getPort(), path));
    return new Camera(1, new CameraOrder("gate", url, null, "hall"));
  }

  private void assertShown(PictureAnswer answer) {
    Shown shown = assertInstanceOf(Shown.class, answer, answer::toString);
    assertArrayEquals(JPEG, shown.bytes());
    assertEquals("image/jpeg", shown.type());
  }

  @Test
  void stillIsHandedOn() {
    serve(200, "image/jpeg", JPEG);

    assertShown(cameras.picture(camera("/still.jpg")));
  }

  @ParameterizedTest
  @CsvSource({
    "'Content-Type: image/jpeg\r\nContent-Length: 9\r\n'",
    "'content-type: image/jpeg\r\n'", // its end is in the picture
  })
  void firstPictureOfAStreamIsHandedOn(String headers) {
    stream(headers);

    assertShown(cameras.picture(camera("/stream.mjpg")));
  }

  @Test
  void pictureOfAStreamThatEndsBeforeItsLengthIsNotHandedOn() {
    end.countDown();
    stream("Content-Type: image/jpeg\r\nContent-Length: 10\r\n");

    assertEquals(new Away(Reason.NO_ANSWER), cameras.picture(camera("/stream.mjpg")));
  }

  @ParameterizedTest
  @CsvSource({
    "302, image/jpeg, REFUSED", // it might lead anywhere
    "401, image/jpeg, REFUSED",
    "200, text/html, NO_PICTURE",
    "200, image/svg+xml, NO_PICTURE", // it might have a script
    "200, image/png, NO_PICTURE", // it is JPEG
    "200, '', NO_PICTURE"
  })
  void whatIsNoPictureIsNot(int status, String type, Reason reason) {
    serve(status, type, JPEG);

    assertEquals(new Away(reason), cameras.picture(camera("/")));
    assertEquals(1, asked.get(), "elsewhere it is not looked");
  }

  @Test
  void pictureIsNoLargerThanIsRead() {
    byte[] large = new byte[3 << 20];
    System.arraycopy(JPEG, 0, large, 0, JPEG.length);
    serve(200, "image/jpeg", large);

    assertEquals(new Away(Reason.TOO_LARGE), cameras.picture(camera("/")));
  }

  @Test
  void cameraThatIsAwayIsSaidToBe() {
    Camera camera = camera("/");
    device.stop(0);

    assertEquals(new Away(Reason.NO_ANSWER), cameras.picture(camera));
  }

  @Test
  void manyWhoLookAtOnceAreOneRequest() throws Exception {
    CountDownLatch all = new CountDownLatch(1);
    device.createContext(
        "/",
        exchange -> {
          try (exchange) {
            asked.incrementAndGet();
            all.await();
            exchange.getResponseHeaders().set("Content-Type", "image/jpeg");
            exchange.sendResponseHeaders(200, JPEG.length);
            exchange.getResponseBody().write(JPEG);
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
    Camera camera = camera("/");
    try (var lookers = Executors.newVirtualThreadPerTaskExecutor()) {
      var pictures =
          IntStream.range(0, 50)
              .mapToObj(i -> lookers.submit(() -> cameras.picture(camera)))
              .toList();
      while (asked.get() == 0) {
        Thread.onSpinWait();
      }
      all.countDown();
      for (var picture : pictures) {
        assertShown(picture.get());
      }
    }
    assertTrue(asked.get() < 5, "asked " + asked.get() + " times");
  }
}
