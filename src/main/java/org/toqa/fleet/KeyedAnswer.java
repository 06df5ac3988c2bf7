package org.toqa.fleet;

/** What became of an order that may have come before with its idempotency key. */
public sealed interface KeyedAnswer<T> {

  /** It came for the first time. */
  record Answered<T>(Answer<T> answer) implements KeyedAnswer<T> {}

  /** It came before, and this is what it made then. */
  record Repeated<T>(T before) implements KeyedAnswer<T> {}

  /** Its key came before with another order. */
  record KeyReused<T>() implements KeyedAnswer<T> {}
}
