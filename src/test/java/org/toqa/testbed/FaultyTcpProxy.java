package org.toqa.testbed;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** A TCP connection on this machine that can be cut in the middle of a line, or fall silent. */
public final class FaultyTcpProxy implements AutoCloseable {
  private enum State {
    WHOLE,
    /** Nothing goes through, and nobody is told: as when the other end is stopped or unplugged. */
    SILENT,
    /** What is sent is lost halfway, with its connection; there is no new one. */
    CUT
  }

  private final int target;
  private final ServerSocket serverSocket;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private State state = State.WHOLE;

  /** It is cut with the first one that is beyond, in either direction. */
  private long bytesUntilCut = Long.MAX_VALUE;

  /**
   * @param target the port of this machine that it leads to
   */
  public FaultyTcpProxy(int target) throws IOException {
    this.target = target;
    this.serverSocket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    Thread.ofVirtual().name("cable-" + target).start(this::accept);
  }

  /** The port of this end. */
  public int port() {
    return serverSocket.getLocalPort();
  }

  /** To the database of this address. */
  public static FaultyTcpProxy toDatabase(String jdbcUrl) throws IOException {
    return new FaultyTcpProxy(URI.create(jdbcUrl.substring("jdbc:".length())).getPort());
  }

  /** The same address, but through this cable. */
  public String through(String url) {
    return url.replace(":" + target, ":" + port());
  }

  public void cut() {
    become(State.CUT);
  }

  /** Cuts it as soon as so many bytes more have gone through, both directions together. */
  public void cutAfter(long bytes) {
    lock.lock();
    try {
      bytesUntilCut = bytes;
    } finally {
      lock.unlock();
    }
  }

  public void silence() {
    become(State.SILENT);
  }

  public void mend() {
    become(State.WHOLE);
  }

  private void become(State next) {
    lock.lock();
    try {
      state = next;
      bytesUntilCut = Long.MAX_VALUE;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private void accept() {
    try {
      while (true) {
        Socket near = serverSocket.accept();
        if (isCut()) {
          near.close();
        } else {
          join(near);
        }
      }
    } catch (IOException e) {
      // closed
    }
  }

  private void join(Socket near) throws IOException {
    try {
      Socket far = new Socket(InetAddress.getLoopbackAddress(), target);
      near.setTcpNoDelay(true);
      far.setTcpNoDelay(true);
      Thread.startVirtualThread(() -> carry(near, far));
      Thread.startVirtualThread(() -> carry(far, near));
    } catch (IOException e) {
      near.close(); // nobody is at home
    }
  }

  private void carry(Socket from, Socket to) {
    byte[] buffer = new byte[8192];
    try (from;
        to) {
      InputStream in = from.getInputStream();
      OutputStream out = to.getOutputStream();
      for (int size = in.read(buffer); size >= 0; size = in.read(buffer)) {
        boolean whole = isCarried(size);
        out.write(buffer, 0, whole ? size : size / 2);
        if (!whole) {
          return;
        }
      }
    } catch (IOException e) {
      // one end has gone, and so goes the other
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean isCut() {
    lock.lock();
    try {
      return state == State.CUT;
    } finally {
      lock.unlock();
    }
  }

  /** Waits while it is silent. */
  private boolean isCarried(int bytes) throws InterruptedException {
    lock.lock();
    try {
      while (state == State.SILENT) {
        changed.await();
      }
      bytesUntilCut -= bytes;
      if (bytesUntilCut < 0) {
        become(State.CUT);
      }
      return state == State.WHOLE;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() throws IOException {
    cut();
    serverSocket.close();
  }
}
