package org.toqa.app.server;

import static org.toqa.app.server.Verdict.FORBIDDEN;
import static org.toqa.app.server.Verdict.GONE;
import static org.toqa.app.server.Verdict.NAME_IN_ADDRESS;
import static org.toqa.app.server.Verdict.NAME_OF_100;
import static org.toqa.app.server.Verdict.NAME_OF_64;
import static org.toqa.app.server.Verdict.PASSWORD;
import static org.toqa.app.server.Verdict.REFUSED;
import static org.toqa.app.server.Verdict.TAKEN;
import static org.toqa.app.server.Verdict.UNKNOWN_USER;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.toqa.notices.NoticeKind;
import org.toqa.web.WebTestServer;

/** All orders of the API that have words, by hand: that none is missing, their test looks after. */
final class OrderCases {
  private static final String TASK =
      """
      {"name":"Box","load":2,"start":{"station":"Goods-in 1"},"goal":{"station":"Mill"},"onlyRobots":["r1"]}\
      """;

  private static final String TOUR =
      """
      {"name":"Box","load":2,"stops":[{"station":"Goods-in 1"},{"station":"Mill","waitSeconds":9}]}\
      """;

  private static final String DRIVE =
      """
      {"name":"Look","kind":"DRIVE","stops":[{"charge":{"charger":"C1"}}]}\
      """;

  private static final String FROM_TEMPLATE =
      """
      {"template":"Usual","values":{"to":{"station":"Mill"},"kg":2}}\
      """;

  private static final String TEMPLATE =
      """
      {"name":"Usual{n}","order":{"load":2,"start":{"station":"Goods-in 1"}},
       "parameters":[{"name":"to","field":"goal"},{"name":"kg","field":"load"}]}\
      """;

  private static final String DRAWING =
      """
      {"width":9,"height":9,"resolution":1,"origin":{"x":0,"y":0},
       "stations":[{"name":"A","x":1,"y":1,"approach":"east"}],
       "parking":[{"name":"P","x":2,"y":1,"approach":"east"}],
       "charging":[{"name":"C","x":3,"y":1,"approach":"east"}],
       "oneWay":[{"x":1,"y":1,"width":1,"height":1,"direction":"east"}]}\
      """;

  /**
   * An order as it should be, and what becomes of an attack in each of its words.
   *
   * @param path below {@code /api/v1/}; what is in braces is put in
   * @param body JSON
   * @param attacked what becomes of an attack, by JSON pointer
   * @param good the status when nothing is wrong
   */
  record OrderCase(
      String method, String path, String body, Map<String, Verdict> attacked, int good) {}

  private OrderCases() {}

  static List<OrderCase> all() {
    return List.of(
        post(
            "session",
            "{'name':'guest{n}','password':'{password}'}",
            Map.of("/name", UNKNOWN_USER, "/password", UNKNOWN_USER),
            200),
        post("forgotten-password", "{'user':'nobody'}", Map.of("/user", TAKEN), 202),
        post(
            "reset-password",
            "{'secret':'{secret}','password':'{password}'}",
            Map.of("/secret", GONE, "/password", PASSWORD),
            204),
        post("tasks", TASK, task(""), 201),
        post("tasks", TOUR, Map.of("/stops/0/station", REFUSED), 201),
        post("tasks", DRIVE, drive(""), 201),
        post("tasks/preview", DRIVE, drive(""), 200),
        new OrderCase("PUT", "tasks/{waiting}", DRIVE, drive(""), 200),
        post("tasks/preview", TASK, task(""), 200),
        post("tasks/preview", TOUR, Map.of("/stops/0/station", REFUSED), 200),
        new OrderCase("PUT", "tasks/{waiting}", TOUR, Map.of("/stops/0/station", REFUSED), 200),
        new OrderCase("PUT", "tasks/{waiting}", TASK, task(""), 200),
        post("tasks/{held}/cancel", "{'load':null}", Map.of("/load", REFUSED), 200),
        post(
            "tasks/{left}/load-moved",
            "{'place':{'station':'Store B'}}",
            Map.of("/place/station", REFUSED),
            200),
        post("tasks/{held}/answer", "{'answer':'wait'}", Map.of("/answer", REFUSED), 409),
        post(
            "orders",
            "{'name':'Box','load':2,'pieces':2,'start':{'station':'Goods-in 1'},'goal':{'station':'Mill'},'onlyRobots':['r1']}",
            task(""),
            201),
        post(
            "orders",
            "{'name':'Box','load':2,'stops':[{'station':'Goods-in 1'},{'station':'Mill'},{'station':'Store A'}]}",
            Map.of("/stops/0/station", REFUSED),
            201),
        post("orders/{order}/cancel", "{'load':null}", Map.of("/load", REFUSED), 200),
        post(
            "schedules",
            "{'task':" + TASK + ",'at':'2099-01-01T10:00:00Z','until':'2099-01-02T10:00:00Z'}",
            Map.of("/at", REFUSED, "/until", REFUSED),
            201),
        post(
            "schedules",
            "{'task':" + TASK + ",'from':'2099-01-01T10:00:00Z','everyMinutes':60}",
            and(task("/task"), Map.of("/from", REFUSED)),
            201),
        post(
            "schedules",
            "{'task':" + TOUR + ",'from':'2099-01-01T10:00:00Z','everyMinutes':60}",
            Map.of("/task/stops/0/station", REFUSED),
            201),
        post(
            "schedules",
            "{'task':" + DRIVE + ",'from':'2099-01-01T10:00:00Z','everyMinutes':60}",
            drive("/task"),
            201),
        post(
            "schedules",
            "{'task':" + TASK + ",'weekdays':['MONDAY'],'time':'08:00','zone':'UTC'}",
            Map.of("/weekdays/0", REFUSED, "/time", REFUSED, "/zone", REFUSED),
            201),
        post(
            "schedules",
            "{'task':" + FROM_TEMPLATE + ",'at':'2099-01-01T10:00:00Z'}",
            Map.of("/task/template", REFUSED, "/task/values/to", REFUSED),
            201),
        post(
            "tasks",
            FROM_TEMPLATE,
            Map.of("/template", REFUSED, "/values/to", REFUSED, "/values/kg", REFUSED),
            201),
        post(
            "tasks/preview",
            FROM_TEMPLATE,
            Map.of("/template", REFUSED, "/values/to", REFUSED, "/values/kg", REFUSED),
            200),
        post("templates", TEMPLATE, template(), 201),
        new OrderCase("PUT", "templates/{template}", TEMPLATE, template(), 200),
        post(
            "robots",
            "{'name':'Spare{n}','host':'127.0.0.1','port':9,'maxLoad':5}",
            Map.of(
                "/name", REFUSED,
                "/host", REFUSED,
                "/parking", REFUSED,
                "/code", REFUSED,
                "/gateway", REFUSED,
                "/floor", REFUSED,
                "/link", REFUSED,
                "/token", REFUSED,
                "/fingerprint", REFUSED),
            201),
        post(
            "robots/{name}/move",
            "{'floor':'{floor}','x':1,'y':1,'theta':0}",
            Map.of("/floor", REFUSED),
            422),
        new OrderCase(
            "PUT",
            "robots/{name}",
            json("{'host':'127.0.0.2','port':9,'maxLoad':56,'parking':null}"),
            Map.of(
                "/host", REFUSED,
                "/parking", REFUSED,
                "/gateway", REFUSED,
                "/token", REFUSED,
                "/fingerprint", REFUSED),
            200),
        post(
            "robots/{name}/pair",
            "{'host':'127.0.0.1','port':9,'code':'{code}'}",
            Map.of("/host", REFUSED, "/code", REFUSED),
            422),
        post(
            "robots/{name}/clear", "{'reasons':['STOP_SWITCH']}", Map.of("/reasons/0", TAKEN), 409),
        post(
            "robots/{name}/drive",
            "{'lease':null,'number':1,'v':0,'w':0}",
            Map.of("/lease", REFUSED),
            409),
        post(
            "laboratory/runs", // none is begun
            "{'experiment':'csm-budget','runs':0}",
            Map.of("/experiment", REFUSED),
            422),
        new OrderCase("PUT", "notices/settings", noticeSettings(), noticeWords(), 200),
        post(
            "webhooks",
            "{'url':'https://8.8.8.8/','kinds':['charger-faulty']}",
            Map.of("/url", REFUSED, "/kinds/0", REFUSED),
            201),
        new OrderCase(
            "PUT",
            "webhooks/1",
            json("{'url':'https://8.8.8.8/','kinds':['charger-faulty'],'enabled':true}"),
            Map.of("/url", REFUSED, "/kinds/0", REFUSED),
            200),
        post(
            "cameras",
            "{'name':'Gate{n}','url':'http://127.0.0.1:9/','floor':'{floor}'}",
            Map.of("/name", REFUSED, "/url", REFUSED, "/robot", REFUSED, "/floor", REFUSED),
            201),
        new OrderCase(
            "PUT",
            "cameras/1",
            json("{'name':'Hatch','url':'http://127.0.0.1:9/','floor':'{floor}'}"),
            Map.of("/name", REFUSED, "/url", REFUSED, "/robot", REFUSED, "/floor", REFUSED),
            200),
        post(
            "network/devices",
            "{'name':'Gate{n}','kind':'camera','address':'10.0.8.1'}",
            Map.of(
                "/name", REFUSED,
                "/kind", REFUSED,
                "/hardwareAddress", REFUSED,
                "/address", REFUSED),
            201),
        new OrderCase(
            "PUT",
            "network/devices/1",
            json("{'name':'Gate','kind':'camera','address':'10.0.7.20'}"),
            Map.of(
                "/name", REFUSED,
                "/kind", REFUSED,
                "/hardwareAddress", REFUSED,
                "/address", REFUSED),
            200),
        post(
            "users",
            "{'name':'New{n}','password':'{password}'}",
            Map.of("/name", REFUSED, "/password", PASSWORD, "/role", REFUSED, "/email", REFUSED),
            201),
        post(
            "sites",
            "{'name':'site{n}','manager':'Nora','password':'{password}'}",
            Map.of("/name", REFUSED, "/manager", REFUSED, "/password", PASSWORD),
            201),
        post(
            "floors",
            "{'name':'Floor{n}','width':3,'height':3,'resolution':1}",
            Map.of("/name", NAME_IN_ADDRESS),
            201),
        post("floors", "{'name':'{floor}','drawing':" + DRAWING + "}", drawing(), 422), // twice
        new OrderCase( // of a draft that is another one by now
            "PUT",
            "floors/{floor}/draft",
            json("{'revision':999999,'drawing':" + DRAWING + "}"),
            drawing(),
            412),
        post("floors/{floor}/draft/check", "{'drawing':" + DRAWING + "}", drawing(), 200),
        post(
            "floors/{floor}/allocator",
            "{'allocator':'zones'}",
            Map.of("/allocator", REFUSED),
            200),
        post( // of robots that have neither cameras nor arms
            "floors/{floor}/supervision",
            "{'supervisor':'r9','workers':['r8'],'boxes':[{'box':1,'target':{'x':1,'y':1}}]}",
            Map.of("/supervisor", REFUSED, "/workers/0", REFUSED),
            422),
        post( // none is begun
            "floors/{floor}/exploration",
            "{'ground':'scene:office','robots':0,'start':{'x':2,'y':2},'target':{'x':22,'y':14}}",
            Map.of("/ground", REFUSED),
            422),
        new OrderCase(
            "PUT", "users/{clerk}", json("{'role':'CLERK'}"), Map.of("/role", REFUSED), 200),
        post(
            "users/{clerk}/password",
            "{'password':'{password}'}",
            Map.of("/password", PASSWORD),
            204),
        post("users/{clerk}/email", "{'email':null}", Map.of("/email", REFUSED), 204),
        post(
            "users/{own}/password",
            "{'old':'{password}','password':'{password}'}",
            Map.of("/old", REFUSED),
            204),
        post(
            "users/{own}/email",
            "{'email':'max@example.org','password':'{password}'}",
            Map.of("/password", REFUSED),
            204),
        post(
            "users/{own}/tokens",
            "{'name':'for a program','days':30,'scopes':['read'],'password':'{password}'}",
            Map.of("/name", FORBIDDEN, "/scopes/0", FORBIDDEN, "/password", FORBIDDEN),
            403)); // made in a browser only
  }

  private static String noticeSettings() {
    return json(
        NoticeKind.ALL.stream()
            .map(kind -> "'" + kind.word() + "':['badge']")
            .collect(
                Collectors.joining(
                    ",",
                    "{'channels':{",
                    "},'quietFrom':'22:00','quietUntil':'06:00','zone':'UTC'}")));
  }

  private static Map<String, Verdict> noticeWords() {
    Map<String, Verdict> words =
        new HashMap<>(Map.of("/quietFrom", REFUSED, "/quietUntil", REFUSED, "/zone", REFUSED));
    NoticeKind.ALL.forEach(kind -> words.put("/channels/" + kind.word() + "/0", REFUSED));
    return words;
  }

  private static Map<String, Verdict> drawing() {
    Map<String, Verdict> words =
        new HashMap<>(Map.of("/drawing/oneWay/0/direction", REFUSED, "/drawing/moves", REFUSED));
    for (String kind : List.of("stations", "parking", "charging")) {
      words.put("/drawing/" + kind + "/0/name", NAME_OF_64);
      words.put("/drawing/" + kind + "/0/approach", REFUSED);
    }
    return words;
  }

  private static Map<String, Verdict> drive(String at) {
    return Map.of(at + "/kind", REFUSED, at + "/stops/0/charge/charger", REFUSED);
  }

  private static Map<String, Verdict> task(String at) {
    return Map.of(
        at + "/name", NAME_OF_100,
        at + "/start/station", REFUSED,
        at + "/goal/station", REFUSED,
        at + "/floor", REFUSED,
        at + "/deadline", REFUSED,
        at + "/onlyRobots/0", REFUSED);
  }

  private static OrderCase post(String path, String body, Map<String, Verdict> attacked, int good) {
    return new OrderCase("POST", path, json(body), attacked, good);
  }

  private static String json(String body) {
    return body.replace('\'', '"')
        .replace("{password}", WebTestServer.PASSWORD)
        .replace("{code}", AttackedServer.PAIRING_CODE);
  }

  private static Map<String, Verdict> template() {
    return Map.of(
        "/name", NAME_OF_100,
        "/order/start/station", REFUSED,
        "/parameters/0/name", REFUSED,
        "/parameters/0/field", REFUSED);
  }

  private static Map<String, Verdict> and(Map<String, Verdict> first, Map<String, Verdict> more) {
    Map<String, Verdict> both = new HashMap<>(first);
    both.putAll(more);
    return both;
  }
}
