package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.network.Device;
import org.toqa.network.DeviceKind;
import org.toqa.network.DeviceOrder;
import org.toqa.network.DeviceStore;
import org.toqa.network.HardwareAddress;
import org.toqa.network.Ipv4Address;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Devices of the network; who changed what of them is in the history. */
public final class JdbiDeviceStore implements DeviceStore {
  private static final String SELECT =
      "select id, name, kind, hardware_address, address from network_devices";

  /** In the history. */
  private static final String NONE = "-";

  private final SqlExecutor sql;
  private final InstantSource clock;

  public JdbiDeviceStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  @Override
  public List<Device> devices() {
    return sql.withHandle(
        h -> h.createQuery(SELECT + " order by name").map((row, _) -> device(row)).list());
  }

  private static Optional<Device> device(Handle h, long id) {
    return h.createQuery(SELECT + " where id = :id for update")
        .bind("id", id)
        .map((row, _) -> device(row))
        .findOne();
  }

  private static Device device(ResultSet row) throws SQLException {
    String hardware = row.getString("hardware_address");
    String address = row.getString("address");
    return new Device(
        row.getLong("id"),
        new DeviceOrder(
            row.getString("name"),
            DeviceKind.ofWord(row.getString("kind")).orElse(DeviceKind.OTHER),
            hardware == null ? null : new HardwareAddress(hardware),
            address == null ? null : Ipv4Address.parse(address).orElse(null)));
  }

  @Override
  public Device add(DeviceOrder order, String by) {
    return sql.inTransaction(
        h -> {
          long id =
              h.createUpdate(
                      """
                      insert into network_devices (name, kind, hardware_address, address)
                      values (:name, :kind, :hardware, :address)
                      """)
                  .bindMap(columns(order))
                  .executeAndReturnGeneratedKeys("id")
                  .mapTo(Long.class)
                  .one();
          tell(h, EventKind.NETWORK_DEVICE_ADDED, order, by, Phrase.DEVICE_ADDED);
          return new Device(id, order);
        });
  }

  @Override
  public boolean change(long id, DeviceOrder order, String by) {
    return sql.inTransaction(
        h -> {
          Optional<Device> before = device(h, id);
          if (before.isPresent() && !before.get().order().equals(order)) {
            h.createUpdate(
                    """
                    update network_devices set name = :name, kind = :kind,
                      hardware_address = :hardware, address = :address
                    where id = :id
                    """)
                .bindMap(columns(order))
                .bind("id", id)
                .execute();
            tell(h, EventKind.NETWORK_DEVICE_CHANGED, order, by, Phrase.DEVICE_CHANGED);
          }
          return before.isPresent();
        });
  }

  @Override
  public boolean delete(long id, String by) {
    return sql.inTransaction(
        h -> {
          Optional<Device> before = device(h, id);
          before.ifPresent(
              device -> {
                h.execute("delete from network_devices where id = ?", id);
                tell(
                    h, EventKind.NETWORK_DEVICE_REMOVED, device.order(), by, Phrase.DEVICE_REMOVED);
              });
          return before.isPresent();
        });
  }

  private static Map<String, @Nullable Object> columns(DeviceOrder order) {
    Map<String, @Nullable Object> columns = new HashMap<>();
    columns.put("name", order.name());
    columns.put("kind", order.kind().word());
    columns.put("hardware", order.hardware() == null ? null : order.hardware().text());
    columns.put("address", order.address() == null ? null : order.address().toString());
    return columns;
  }

  private void tell(Handle h, EventKind kind, DeviceOrder order, String by, Phrase phrase) {
    Sentence said =
        phrase.with(by, order.name(), textOrNone(order.address()), textOrNone(order.hardware()));
    EventTable.addAll(
        h,
        List.of(
            new EventRecord(
                clock.instant(),
                kind,
                null,
                order.kind() == DeviceKind.ROBOT ? order.name() : null,
                by,
                said)));
  }

  private static String textOrNone(@Nullable Object value) {
    return value == null ? NONE : value.toString();
  }
}
