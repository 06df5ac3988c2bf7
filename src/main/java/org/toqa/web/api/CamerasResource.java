package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.toqa.camera.Camera;
import org.toqa.camera.CameraOrder;
import org.toqa.camera.PictureAnswer;
import org.toqa.web.CameraList;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.CameraReader;

/** Cameras, and what they see now. */
public final class CamerasResource extends ApiHandler {
  private static final int BAD_GATEWAY = 502;

  /** Its address may have a password in it: managers alone are told. */
  private record CameraJson(
      long id, String name, @Nullable String robot, @Nullable String floor, @Nullable String url) {
    static CameraJson of(Camera camera, Caller caller) {
      return new CameraJson(
          camera.id(),
          camera.name(),
          camera.robot(),
          camera.floor(),
          caller.mayManage() ? camera.url().toString() : null);
    }
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Caller caller = Caller.of(request);
    Json.send(
        request,
        response,
        200,
        new CameraList(services(request))
            .all().stream().map(camera -> CameraJson.of(camera, caller)).toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    CameraList cameras = new CameraList(services(request));
    Caller caller = Caller.of(request);
    CameraOrder order = readBody(request, fields -> CameraReader.read(fields, cameras));
    Camera added = cameras.cameras().add(order, caller.name());
    Json.send(request, response, 201, CameraJson.of(added, caller));
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    CameraList cameras = new CameraList(services(request));
    Caller caller = Caller.of(request);
    long id = camera(request).id();
    Camera changed = readBody(request, fields -> CameraReader.read(fields, cameras, id));
    if (!cameras.cameras().change(changed, caller.name())) {
      throw notFound(request);
    }
    Json.send(request, response, 200, CameraJson.of(changed, caller));
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    Camera camera = camera(request);
    services(request).cameras().delete(camera.id(), Caller.of(request).name());
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void picture(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    switch (services(request).cameras().picture(camera(request))) {
      case PictureAnswer.Shown(byte[] bytes, String type) -> {
        response.setContentType(type);
        response.setHeader("Cache-Control", "no-store");
        response.setContentLength(bytes.length);
        response.getOutputStream().write(bytes);
      }
      case PictureAnswer.Away(PictureAnswer.Reason reason) ->
          throw Problem.of(BAD_GATEWAY, Texts.of(request).get("camera.away." + reason)).exception();
    }
  }

  private static Camera camera(HttpServletRequest request) {
    return services(request)
        .cameras()
        .camera(RequestPath.number(request, "id"))
        .orElseThrow(() -> notFound(request));
  }

  private static RuntimeException notFound(HttpServletRequest request) {
    return Problem.of(404, Texts.of(request).get("problem.noSuchCamera")).exception();
  }
}
