package org.toqa.web.input;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.PairingOrder;
import org.toqa.link.trust.PairingCode;
import org.toqa.web.Texts;

/**
 * What a manager enters to pair a robot that is known, before it is looked at.
 *
 * @param port null: missing, or it has its sentence already
 */
public record PairingFields(@Nullable String host, @Nullable Double port, @Nullable String code) {

  /** The wish; empty, with a sentence at each field at fault, where it cannot be had. */
  public Optional<PairingOrder> read(Texts texts, FieldErrors errors) {
    InputRules rules = new InputRules(texts, errors);
    String checkedHost = rules.host("host", host);
    int checkedPort = rules.port("port", port);
    PairingCode checkedCode = rules.pairingCode("code", code == null ? "" : code);
    return checkedCode == null || !errors.isEmpty()
        ? Optional.empty()
        : Optional.of(new PairingOrder(checkedHost, checkedPort, checkedCode));
  }
}
