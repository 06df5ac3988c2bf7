package org.toqa.link.message;

import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonSubTypes.Type;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.Nulls;
import org.jspecify.annotations.Nullable;

/** What a server and a robot say to each other on a connection for pairing. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonSubTypes({
  @Type(value = PairingMessage.Pair.class, name = "pair"),
  @Type(value = PairingMessage.Paired.class, name = "paired"),
  @Type(value = PairingMessage.Unpaired.class, name = "unpaired"),
})
public sealed interface PairingMessage {

  /**
   * The server asks to be the robot's only server.
   *
   * @param robot whom it means; null: it does not say, as a server of an earlier release
   * @param proof that it knows the code
   */
  record Pair(@JsonSetter(nulls = Nulls.SET) @Nullable String robot, String proof)
      implements PairingMessage {}

  /**
   * The robot has recorded the server's certificate.
   *
   * @param robot its name
   * @param proof that it knows the code
   */
  record Paired(String robot, String proof) implements PairingMessage {}

  /**
   * The robot has refused, and nothing has changed.
   *
   * @param reason a sentence for people
   */
  record Unpaired(String reason) implements PairingMessage {}
}
