package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Function;
import org.toqa.network.Device;
import org.toqa.network.DeviceAnswer;
import org.toqa.network.DeviceKind;
import org.toqa.network.DeviceOrder;
import org.toqa.network.Network;
import org.toqa.web.NetworkDevices;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.DeviceReader;
import org.toqa.web.input.FieldErrors;

/**
 * Devices of the network and their addresses; managers say what they are, and reserve addresses.
 */
public final class NetworkPage extends PageHandler {
  private static final String VIEW = "network";
  private static final String PATH = "/network";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    wanted(request).ifPresent(device -> request.setAttribute("edited", device));
    show(request, response, VIEW);
  }

  /** The device that is to be changed; empty: a new one, or there is none of that id. */
  private static Optional<Device> wanted(HttpServletRequest request) {
    String id = request.getParameter("edit");
    return id == null || !id.matches("[0-9]{1,18}")
        ? Optional.empty()
        : services(request).network().device(Long.parseLong(id));
  }

  private static void addAttributes(HttpServletRequest request) {
    NetworkDevices devices = new NetworkDevices(services(request));
    Network network = devices.network();
    request.setAttribute("entries", devices.entries());
    request.setAttribute("subnet", network.subnet().orElse(null));
    request.setAttribute("trouble", network.trouble().orElse(null));
    request.setAttribute("kinds", DeviceKind.values());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    store(
        request,
        response,
        order -> new NetworkDevices(services(request)).add(order, Caller.of(request).name()),
        "added");
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Device> device = device(request, response);
    if (device.isPresent()) {
      request.setAttribute("edited", device.get());
      store(
          request,
          response,
          order ->
              new NetworkDevices(services(request))
                  .change(device.get().id(), order, Caller.of(request).name()),
          "changed");
    }
  }

  private static void store(
      HttpServletRequest request,
      HttpServletResponse response,
      Function<DeviceOrder, DeviceAnswer> network,
      String done)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<DeviceAnswer> answer = readForm(request, errors, DeviceReader::read).map(network);
    if (answer.isPresent() && answer.get() instanceof DeviceAnswer.Unknown) {
      sendNotFound(request, response, "problem.noSuchDevice");
      return;
    }
    if (answer.isPresent() && answer.get() instanceof DeviceAnswer.Refused(var refusals)) {
      DeviceReader.file(refusals, new FormFields(request, errors));
    }
    if (errors.isEmpty()) {
      redirect(request, response, PATH + "?done=" + done);
    } else {
      addAttributes(request);
      showAgain(request, response, VIEW, errors);
    }
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Device> device = device(request, response);
    if (device.isPresent()) {
      services(request).network().delete(device.get().id(), Caller.of(request).name());
      redirect(request, response, PATH + "?done=removed");
    }
  }

  /** The device in the path; empty when the answer is given: there is none. */
  private static Optional<Device> device(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Device> device = services(request).network().device(RequestPath.number(request, "id"));
    if (device.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchDevice");
    }
    return device;
  }
}
