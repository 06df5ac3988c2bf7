package org.toqa.app.demo;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.util.concurrent.Executors;
import java.util.function.Supplier;
import javax.imageio.ImageIO;

/**
 * Simulated cameras, which answer over HTTP on loopback as real ones do in a laboratory's network:
 * {@code /NAME.png} is what that camera sees now.
 */
final class DemoCameras implements AutoCloseable {
  private static final int OK = 200;

  private final HttpServer server;

  DemoCameras() throws IOException {
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.setExecutor(Executors.newVirtualThreadPerTaskExecutor());
    server.start();
  }

  /**
   * One more.
   *
   * @param view draws what it sees
   * @return where it answers
   */
  URI add(String name, Supplier<BufferedImage> view) {
    String path = "/" + name + ".png";
    server.createContext(path, exchange -> answer(exchange, view.get()));
    return URI.create("http://127.0.0.1:" + server.getAddress().getPort() + path);
  }

  private static void answer(HttpExchange exchange, BufferedImage picture) throws IOException {
    try (exchange) {
      ByteArrayOutputStream png = new ByteArrayOutputStream();
      ImageIO.write(picture, "png", png);
      exchange.getResponseHeaders().set("Content-Type", "image/png");
      exchange.sendResponseHeaders(OK, png.size());
      png.writeTo(exchange.getResponseBody());
    }
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
