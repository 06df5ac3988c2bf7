package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.network.Device;
import org.toqa.network.DeviceAnswer;
import org.toqa.network.DeviceOrder;
import org.toqa.network.DhcpTrouble;
import org.toqa.network.Lease;
import org.toqa.network.Network;
import org.toqa.network.NetworkEntry;
import org.toqa.web.NetworkDevices;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.DeviceReader;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.JsonFields;

/** Devices of the network and their addresses. */
public final class NetworkResource extends ApiHandler {

  private record NetworkJson(@Nullable DhcpJson dhcp, List<EntryJson> devices) {}

  private record DhcpJson(String subnet, @Nullable String trouble) {}

  private record LeaseJson(String address, @Nullable Instant until, @Nullable String hostName) {
    static LeaseJson of(Lease lease) {
      return new LeaseJson(lease.address().toString(), lease.until(), lease.hostName());
    }
  }

  private record EntryJson(
      @Nullable Long id,
      @Nullable String name,
      @Nullable String kind,
      boolean isRobot,
      @Nullable String address,
      @Nullable String hardwareAddress,
      @Nullable String reserved,
      @Nullable LeaseJson lease,
      @Nullable Boolean reachable,
      @Nullable Instant heardAt) {
    static EntryJson of(NetworkEntry entry, boolean isServed) {
      Device device = entry.device();
      return new EntryJson(
          device == null ? null : device.id(),
          entry.name(),
          entry.kind() == null ? null : entry.kind().word(),
          entry.isRobot(),
          entry.address(),
          entry.hardware() == null ? null : entry.hardware().text(),
          isServed && device != null && device.isReservable() && device.address() != null
              ? device.address().toString()
              : null,
          entry.lease() == null ? null : LeaseJson.of(entry.lease()),
          entry.reachable(),
          entry.heardAt());
    }
  }

  private record DeviceJson(
      long id,
      String name,
      String kind,
      @Nullable String hardwareAddress,
      @Nullable String address) {
    static DeviceJson of(Device device) {
      return new DeviceJson(
          device.id(),
          device.name(),
          device.kind().word(),
          device.hardware() == null ? null : device.hardware().text(),
          device.address() == null ? null : device.address().toString());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    NetworkDevices devices = new NetworkDevices(services(request));
    Network network = devices.network();
    DhcpJson dhcp =
        network
            .subnet()
            .map(
                subnet ->
                    new DhcpJson(
                        subnet.toString(),
                        network.trouble().map(trouble -> sentence(request, trouble)).orElse(null)))
            .orElse(null);
    Json.send(
        request,
        response,
        200,
        new NetworkJson(
            dhcp,
            devices.entries().stream().map(entry -> EntryJson.of(entry, dhcp != null)).toList()));
  }

  private static String sentence(HttpServletRequest request, DhcpTrouble trouble) {
    return Texts.of(request).get("network.trouble." + trouble.kind(), trouble.what());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    NetworkDevices devices = new NetworkDevices(services(request));
    Device added = stored(request, order -> devices.add(order, Caller.of(request).name()));
    Json.send(request, response, 201, DeviceJson.of(added));
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    long id = device(request).id();
    NetworkDevices devices = new NetworkDevices(services(request));
    Device changed = stored(request, order -> devices.change(id, order, Caller.of(request).name()));
    Json.send(request, response, 200, DeviceJson.of(changed));
  }

  private static Device stored(
      HttpServletRequest request, Function<DeviceOrder, DeviceAnswer> network) throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    DeviceOrder order = DeviceReader.read(fields);
    throwIfAny(errors);
    return switch (network.apply(order)) {
      case DeviceAnswer.Stored(Device device) -> device;
      case DeviceAnswer.Unknown() -> throw notFound(request);
      case DeviceAnswer.Refused(var refusals) -> {
        DeviceReader.file(refusals, fields);
        throwIfAny(errors);
        throw new IllegalStateException("refused without a reason");
      }
    };
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    services(request).network().delete(device(request).id(), Caller.of(request).name());
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static Device device(HttpServletRequest request) {
    return services(request)
        .network()
        .device(RequestPath.number(request, "id"))
        .orElseThrow(() -> notFound(request));
  }

  private static RuntimeException notFound(HttpServletRequest request) {
    return Problem.of(404, Texts.of(request).get("problem.noSuchDevice")).exception();
  }
}
