package org.toqa.web.input;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.network.DeviceAnswer.Refusal;
import org.toqa.network.DeviceKind;
import org.toqa.network.DeviceOrder;
import org.toqa.network.HardwareAddress;
import org.toqa.network.Ipv4Address;

/** Reads what a manager says of a device of the network. */
public final class DeviceReader {
  private static final String NAME = "name";
  private static final String KIND = "kind";
  private static final String HARDWARE = "hardwareAddress";
  private static final String ADDRESS = "address";

  private final Fields fields;

  private DeviceReader(Fields fields) {
    this.fields = fields;
  }

  /** It means something only when no error was filed. */
  public static DeviceOrder read(Fields fields) {
    DeviceReader reader = new DeviceReader(fields);
    DeviceOrder order =
        new DeviceOrder(
            fields.rules().deviceName(NAME, fields.text(NAME)),
            reader.kind(),
            reader.hardware(),
            reader.address());
    if (order.hardware() == null
        && order.address() == null
        && !fields.has(HARDWARE)
        && !fields.has(ADDRESS)) {
      reader.refuse(ADDRESS, "error.device.neither");
    }
    fields.refuseUnknown();
    return order;
  }

  private DeviceKind kind() {
    String word = fields.text(KIND);
    Optional<DeviceKind> kind = word == null ? Optional.empty() : DeviceKind.ofWord(word);
    if (kind.isEmpty()) {
      refuse(KIND, "error.device.kind");
    }
    return kind.orElse(DeviceKind.OTHER);
  }

  private @Nullable HardwareAddress hardware() {
    String given = fields.text(HARDWARE);
    if (given == null) {
      return null;
    }
    Optional<HardwareAddress> address = HardwareAddress.parse(given.strip());
    if (address.isEmpty()) {
      refuse(HARDWARE, "error.device.hardware");
    }
    return address.orElse(null);
  }

  private @Nullable Ipv4Address address() {
    String given = fields.text(ADDRESS);
    if (given == null) {
      return null;
    }
    Optional<Ipv4Address> address =
        Ipv4Address.parse(given.strip()).filter(Ipv4Address::isOfDevice);
    if (address.isEmpty()) {
      refuse(ADDRESS, "error.device.address");
    }
    return address.orElse(null);
  }

  /** Files why the network refused an order. */
  public static void file(List<Refusal> refusals, Fields fields) {
    DeviceReader reader = new DeviceReader(fields);
    for (Refusal refusal : refusals) {
      String field =
          switch (refusal.reason()) {
            case NAME_TAKEN, TOO_MANY -> NAME;
            case HARDWARE_TAKEN -> HARDWARE;
            case ADDRESS_TAKEN,
                ADDRESS_OF_ROBOT,
                ADDRESS_OF_SERVER,
                ADDRESS_OUTSIDE,
                ADDRESS_LEASED ->
                ADDRESS;
          };
      reader.refuse(field, "error.device." + refusal.reason(), refusal.with());
    }
  }

  private void refuse(String field, String key, Object... values) {
    fields.errors().add(fields.path(field), fields.texts().get(key, values));
  }
}
