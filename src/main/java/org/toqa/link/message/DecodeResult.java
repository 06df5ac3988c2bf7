package org.toqa.link.message;

/**
 * What became of a received line.
 *
 * @param <M> the messages that this end may receive
 */
public sealed interface DecodeResult<M> {

  record Decoded<M>(M message) implements DecodeResult<M> {}

  /**
   * Nothing of the line has any effect.
   *
   * @param seq the line's sequence number, 0 where it bore none
   * @param reason a sentence for the sender
   */
  record Invalid<M>(long seq, String reason) implements DecodeResult<M> {}
}
