package org.toqa.agent.firmware;

import java.util.Arrays;
import java.util.Optional;

/**
 * Finds the frames in a stream of bytes, where some may have been lost, changed or added: a frame
 * begins at the sync bytes, and what begins there and is no good frame is passed over byte by byte.
 */
final class FrameScanner {

  private static final int CAPACITY = 4 * FrameCodec.LENGTH;

  private final byte[] bytes = new byte[CAPACITY];
  private int count;

  /** Forgets what was half received. */
  void clear() {
    count = 0;
  }

  /** Takes the first {@code length} bytes; of too many the oldest go. */
  void add(byte[] received, int length) {
    int kept = Math.min(length, CAPACITY);
    drop(Math.max(0, count + kept - CAPACITY));
    System.arraycopy(received, length - kept, bytes, count, kept);
    count += kept;
  }

  /** The oldest good frame; it and everything before it is gone then. */
  Optional<byte[]> takeFrame() {
    int begin = 0;
    while (begin + FrameCodec.LENGTH <= count) {
      byte[] frame = Arrays.copyOfRange(bytes, begin, begin + FrameCodec.LENGTH);
      if (FrameCodec.isIntact(frame)) {
        drop(begin + FrameCodec.LENGTH);
        return Optional.of(frame);
      }
      begin++;
    }
    drop(begin);
    return Optional.empty();
  }

  private void drop(int oldest) {
    System.arraycopy(bytes, oldest, bytes, 0, count - oldest);
    count -= oldest;
  }
}
