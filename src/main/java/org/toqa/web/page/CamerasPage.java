package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.camera.Camera;
import org.toqa.camera.CameraOrder;
import org.toqa.web.CameraList;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.CameraReader;
import org.toqa.web.input.FieldErrors;

/** All cameras with what they see; managers add, change and remove some. */
public final class CamerasPage extends PageHandler {
  private static final String VIEW = "cameras";
  private static final String PATH = "/cameras";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    wanted(request).ifPresent(camera -> request.setAttribute("edited", camera));
    show(request, response, VIEW);
  }

  /** The camera that is to be changed; empty: a new one, or there is none of that id. */
  private static Optional<Camera> wanted(HttpServletRequest request) {
    String id = request.getParameter("edit");
    return id == null || !id.matches("[0-9]{1,18}")
        ? Optional.empty()
        : services(request).cameras().camera(Long.parseLong(id));
  }

  private static void addAttributes(HttpServletRequest request) {
    CameraList cameras = new CameraList(services(request));
    request.setAttribute("cameras", cameras.all());
    request.setAttribute("robots", cameras.robots());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    CameraList cameras = new CameraList(services(request));
    Optional<CameraOrder> order =
        readForm(request, errors, fields -> CameraReader.read(fields, cameras));
    if (order.isPresent()) {
      cameras.cameras().add(order.get(), Caller.of(request).name());
      redirect(request, response, PATH + "?done=added");
    } else {
      addAttributes(request);
      showAgain(request, response, VIEW, errors);
    }
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    CameraList cameras = new CameraList(services(request));
    Optional<Camera> camera = cameras.cameras().camera(RequestPath.number(request, "id"));
    if (camera.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchCamera");
      return;
    }
    FieldErrors errors = new FieldErrors();
    Optional<Camera> changed =
        readForm(request, errors, fields -> CameraReader.read(fields, cameras, camera.get().id()));
    if (changed.isEmpty()) {
      addAttributes(request);
      request.setAttribute("edited", camera.get());
      showAgain(request, response, VIEW, errors);
    } else if (cameras.cameras().change(changed.get(), Caller.of(request).name())) {
      redirect(request, response, PATH + "?done=changed");
    } else {
      sendNotFound(request, response, "problem.noSuchCamera");
    }
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    boolean isDone =
        services(request)
            .cameras()
            .delete(RequestPath.number(request, "id"), Caller.of(request).name());
    if (isDone) {
      redirect(request, response, PATH + "?done=removed");
    } else {
      sendNotFound(request, response, "problem.noSuchCamera");
    }
  }
}
