package org.toqa.web;

/**
 * What one user or address, or all together, may have open at once.
 *
 * @param requests that are being answered, by address
 * @param streamsByUser live streams
 * @param streamsByAddress live streams
 * @param streams live streams of all together, under one name
 */
public record ConcurrencyLimits(
    ConcurrencyLimit requests,
    ConcurrencyLimit streamsByUser,
    ConcurrencyLimit streamsByAddress,
    ConcurrencyLimit streams) {

  /** For as many streams of all together as are half of the connections. */
  public static ConcurrencyLimits of(
      int requestsAtOnce, int streamsPerUser, int streamsPerAddress, int connections) {
    return new ConcurrencyLimits(
        new ConcurrencyLimit(requestsAtOnce),
        new ConcurrencyLimit(streamsPerUser),
        new ConcurrencyLimit(streamsPerAddress),
        new ConcurrencyLimit(connections / 2));
  }
}
