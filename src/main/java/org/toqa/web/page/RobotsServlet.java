package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.Answer;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotView;
import org.toqa.web.FieldErrors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** All robots; managers add some. */
public final class RobotsServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    offerFleet(request);
    show(request, response, "robots");
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    RobotOrder order = read(request, errors);
    if (errors.isEmpty()) {
      switch (FleetAnswers.await(services().fleet().addRobot(order, Caller.of(request).name()))) {
        case Answer.Accepted<RobotView>(RobotView robot) -> {
          goTo(request, response, "/robots/" + robot.name());
          return;
        }
        case Answer.Refused<RobotView> refused -> file(refused, errors);
        case Answer.Unknown<RobotView>(String sentence) -> errors.add("form", sentence);
      }
    }
    offerFleet(request);
    showAgain(request, response, "robots", errors);
  }

  private static RobotOrder read(HttpServletRequest request, FieldErrors errors) {
    FormFields fields = new FormFields(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    return new RobotOrder(
        rules.robotName("name", fields.text("name")),
        rules.host("host", fields.text("host")),
        rules.port("port", fields.number("port")),
        rules.load("maxLoad", fields.number("maxLoad")),
        fields.text("parking"));
  }

  private void offerFleet(HttpServletRequest request) {
    request.setAttribute("robots", services().fleet().feed().latest().robots());
    request.setAttribute("floors", services().fleet().floors());
  }
}
