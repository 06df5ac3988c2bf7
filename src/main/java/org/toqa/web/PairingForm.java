package org.toqa.web;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.PairingOrder;
import org.toqa.link.trust.PairingCode;

/**
 * What a manager enters to pair a robot that is known, before it is looked at.
 *
 * @param port null: missing, or it has its sentence already
 */
public record PairingForm(@Nullable String host, @Nullable Double port, @Nullable String code) {

  /** The wish; empty, with a sentence at each field at fault, where it cannot be had. */
  public Optional<PairingOrder> order(Texts texts, FieldErrors errors) {
    InputRules rules = new InputRules(texts, errors);
    String at = rules.host("host", host);
    int listening = rules.port("port", port);
    PairingCode shown = rules.pairingCode("code", code == null ? "" : code);
    return shown == null || !errors.isEmpty()
        ? Optional.empty()
        : Optional.of(new PairingOrder(at, listening, shown));
  }
}
