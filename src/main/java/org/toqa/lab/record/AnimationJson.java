package org.toqa.lab.record;

import org.toqa.geometry.Vec2;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Scene;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** How the bodies of a scene move, as a program reads it. */
public final class AnimationJson {
  private static final double MILLIMETRES = 1000;

  private AnimationJson() {}

  /** On one line; metres to the millimetre, and where the scene lies in its picture. */
  public static String text(Animation animation) {
    Scene.Frame frame = animation.ground().frame();
    ObjectNode json = JsonMapper.shared().createObjectNode();
    json.put("step", animation.step());
    json.putObject("picture")
        .put("width", frame.width())
        .put("height", frame.height())
        .put("left", frame.left())
        .put("top", frame.top())
        .put("scale", frame.scale());
    put(json.putArray("least"), animation.ground().least());
    put(json.putArray("most"), animation.ground().most());
    ArrayNode bodies = json.putArray("bodies");
    for (Animation.Body body : animation.bodies()) {
      ObjectNode one = bodies.addObject();
      one.put("label", body.label());
      one.put("radius", body.radius());
      one.put("colour", body.colour().code());
      ArrayNode track = one.putArray("track");
      body.track().forEach(at -> put(track.addArray(), at));
    }
    return JsonMapper.shared().writeValueAsString(json);
  }

  private static void put(ArrayNode json, Vec2 at) {
    json.add(Math.round(at.x() * MILLIMETRES) / MILLIMETRES);
    json.add(Math.round(at.y() * MILLIMETRES) / MILLIMETRES);
  }
}
