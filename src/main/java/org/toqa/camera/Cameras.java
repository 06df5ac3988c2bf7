package org.toqa.camera;

import com.github.benmanes.caffeine.cache.AsyncCache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.io.IOException;
import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * The cameras of a site. Any thread may call it. However many look at a camera, it is asked for a
 * picture five times a second at most, by one request at a time.
 */
public final class Cameras implements AutoCloseable {

  /** Of a site. */
  public static final int MOST = 100;

  private static final Duration FRESH = Duration.ofMillis(200);

  private final CameraStore store;
  private final CameraClient client = new CameraClient();
  private final ExecutorService threads = Executors.newVirtualThreadPerTaskExecutor();
  private final AsyncCache<URI, PictureAnswer> pictures =
      Caffeine.newBuilder()
          .maximumSize(MOST)
          .expireAfterWrite(FRESH)
          .executor(Runnable::run)
          .buildAsync();

  public Cameras(CameraStore store) {
    this.store = store;
  }

  /** By their names. */
  public List<Camera> all() {
    return store.cameras();
  }

  public List<Camera> ofRobot(String robot) {
    return all().stream().filter(camera -> robot.equals(camera.robot())).toList();
  }

  public Optional<Camera> camera(long id) {
    return all().stream().filter(camera -> camera.id() == id).findFirst();
  }

  /**
   * @param by a user's name
   */
  public Camera add(CameraOrder order, String by) {
    return store.add(order, by);
  }

  /**
   * What it shows from now on is asked at its new address.
   *
   * @param by a user's name
   * @return false: there is no such camera
   */
  public boolean change(Camera camera, String by) {
    return store.change(camera, by);
  }

  /**
   * @param by a user's name
   * @return false: there is no such camera
   */
  public boolean delete(long id, String by) {
    return store.delete(id, by);
  }

  /** What it sees now; waits for it, some seconds at most. */
  public PictureAnswer picture(Camera camera) {
    return pictures
        .get(
            camera.url(), (url, _) -> CompletableFuture.supplyAsync(() -> client.ask(url), threads))
        .join();
  }

  @Override
  public void close() throws IOException {
    client.close();
    threads.close();
  }
}
