package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.web.ErrorResponse;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.wording.Sentence;

/** The forms on the live map that hold and resume all robots of a floor. */
public final class FloorForms extends PageHandler {
  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::holdFloor);
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    command(request, response, Fleet::resumeFloor);
  }

  public static void allocator(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<String> allocator =
        Optional.ofNullable(request.getParameter("allocator")).filter(word -> !word.isEmpty());
    command(
        request, response, (fleet, floor, user) -> fleet.chooseAllocator(floor, allocator, user));
  }

  @FunctionalInterface
  private interface FloorCommand {
    CompletionStage<? extends Answer<?>> send(Fleet fleet, String floor, String user);
  }

  private static void command(
      HttpServletRequest request, HttpServletResponse response, FloorCommand command)
      throws IOException {
    Answer<?> answer =
        FleetAnswers.await(
            command.send(
                services(request).fleet(),
                RequestPath.parameter(request, "floor"),
                Caller.of(request).name()));
    Texts texts = Texts.of(request);
    switch (answer) {
      case Answer.Unknown<?>(Sentence sentence) ->
          ErrorResponse.send(request, response, 404, texts.text(sentence));
      case Answer.Rejected<?>(String _, Sentence sentence) ->
          ErrorResponse.send(request, response, 422, texts.text(sentence));
      default -> redirect(request, response, "/map");
    }
  }
}
