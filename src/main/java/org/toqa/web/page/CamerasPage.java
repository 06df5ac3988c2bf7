package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.camera.CameraOrder;
import org.toqa.web.CameraList;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.CameraReader;
import org.toqa.web.input.FieldErrors;

/** All cameras with what they see; managers add and remove some. */
public final class CamerasPage extends PageHandler {
  private static final String VIEW = "cameras";
  private static final String PATH = "/cameras";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    show(request, response, VIEW);
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
