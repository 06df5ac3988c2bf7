package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.PasswordRules;
import org.toqa.accounts.Role;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Site;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.TaskOrder;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.mission.RobotAbility;
import org.toqa.mission.TaskKind;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.telemetry.Topics;
import org.toqa.text.GivenName;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/**
 * What values from outside must be, whichever input they come by. Each method files a sentence
 * under the field when the value is refused; what it then answers means nothing. A null number was
 * missing or has its sentence already.
 */
public final class InputRules {
  /** Letters; the columns that hold names of tasks have room for as many. */
  private static final int MAX_TASK_NAME_LENGTH = 100;

  private static final int MAX_HOST_LENGTH = 255;
  private static final int MAX_EMAIL_LENGTH = 254;
  private static final int MAX_TOKEN_NAME_LENGTH = 64;
  private static final int MAX_TOKEN_DAYS = 365;
  private static final int MAX_PORT = 65_535;

  /** Seconds. */
  private static final int MAX_STOP_WAIT = 86_400;

  /** Of 0 to 1. */
  private static final double MIN_CHARGE = 0.05;

  private static final UUID NO_LEASE = new UUID(0, 0);

  /** 2^53: up to here every whole number is exact in any language's JSON. */
  private static final double MAX_ORDER_NUMBER = 0x1p53;

  static final int MAX_PRIORITY = 100;

  /** Kilograms. */
  private static final double MAX_LOAD = 100_000;

  /** Metres, of a load's side. */
  private static final double MAX_SIDE = 10;

  /** Metres from the map's origin. */
  private static final double MAX_COORDINATE = 1_000_000;

  /** Of a reading, in whatever unit. */
  private static final double MAX_LIMIT = 1e12;

  /** Times that every database can hold. */
  private static final Instant EARLIEST = Instant.parse("2000-01-01T00:00:00Z");

  private static final Instant LATEST = Instant.parse("9999-01-01T00:00:00Z");

  private static final Pattern ROBOT_NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,63}");
  private static final Pattern USER_NAME =
      Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N}._@-]{0,63}");

  /** One address, and nothing that an e-mail's header would take for more. */
  private static final Pattern EMAIL =
      Pattern.compile(
          "[A-Za-z0-9.!#$%&'*+/=?^_`{|}~-]{1,64}@[A-Za-z0-9]([A-Za-z0-9.-]*[A-Za-z0-9])?");

  private static final Pattern HOST =
      Pattern.compile("[A-Za-z0-9:]([A-Za-z0-9.:%_-]*[A-Za-z0-9])?");

  private static final String HTTP = "http";
  private static final String ROBOT_LINK = "toqa";

  private final Texts texts;
  private final FieldErrors errors;

  public InputRules(Texts texts, FieldErrors errors) {
    this.texts = texts;
    this.errors = errors;
  }

  public String taskName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    int length = GivenName.length(name);
    if (!GivenName.hasLetters(name)) {
      refuse(field, "error.taskName.missing");
    } else if (length > MAX_TASK_NAME_LENGTH) {
      refuse(field, "error.taskName.long", MAX_TASK_NAME_LENGTH, length);
    } else if (!GivenName.isName(name, MAX_TASK_NAME_LENGTH)) {
      refuse(field, "error.taskName.control");
    }
    return name;
  }

  /** Kilograms. */
  public double load(String field, @Nullable Double given) {
    return inRange(field, given, 0, MAX_LOAD, "error.load.missing", "error.load.range");
  }

  /** Of a task; a transport where none is given. */
  public TaskKind taskKind(String field, @Nullable String given) {
    if (given == null) {
      return TaskKind.TRANSPORT;
    }
    return Stream.of(TaskKind.values())
        .filter(kind -> kind.name().equalsIgnoreCase(given.strip()))
        .findFirst()
        .orElseGet(
            () -> {
              refuse(field, "error.taskKind");
              return TaskKind.TRANSPORT;
            });
  }

  /** Metres, map frame; of a place that may also be a station. */
  public double coordinate(String field, @Nullable Double given) {
    return coordinate(field, given, "error.coordinate.missing");
  }

  /** The same, where no station can be chosen. */
  public double coordinateOfPose(String field, @Nullable Double given) {
    return coordinate(field, given, "error.position.missing");
  }

  private double coordinate(String field, @Nullable Double given, String missing) {
    if (given == null) {
      refuse(field, missing);
      return 0;
    }
    if (!(Math.abs(given) <= MAX_COORDINATE)) {
      refuse(field, "error.coordinate.range", MAX_COORDINATE);
    }
    return given;
  }

  /** Radians in, radians out; any turn is allowed as long as it is a sensible number. */
  public double angle(String field, @Nullable Double given) {
    if (given == null) {
      refuse(field, "error.angle.missing");
      return 0;
    }
    if (!(Math.abs(given) <= 1000)) {
      refuse(field, "error.angle.range");
    }
    return given;
  }

  /** What the answer to the first order of a drive by hand told; null where none is given. */
  public @Nullable UUID lease(String field, @Nullable String given) {
    if (given == null) {
      return null;
    }
    try {
      return UUID.fromString(given);
    } catch (IllegalArgumentException notOurs) {
      refuse(field, "error.lease");
      return null;
    }
  }

  /** The same where there must be one. */
  public UUID requiredLease(String field, @Nullable String given) {
    UUID lease = lease(field, given == null ? "" : given);
    return lease == null ? NO_LEASE : lease;
  }

  /** A whole number that rises from order to order. */
  public long orderNumber(String field, @Nullable Double given) {
    if (given == null || given != Math.rint(given) || !(given >= 0 && given <= MAX_ORDER_NUMBER)) {
      refuse(field, "error.orderNumber");
      return 0;
    }
    return given.longValue();
  }

  /** Either way, up to a limit. */
  public double manualSpeed(String field, @Nullable Double given, double limit) {
    if (given == null || !(Math.abs(given) <= limit)) {
      refuse(field, "error.manualSpeed", limit);
      return 0;
    }
    return given;
  }

  /** How many pieces; one where nothing is given. */
  public int pieces(String field, @Nullable Double given) {
    if (given == null) {
      return 1;
    }
    if (given != Math.rint(given) || !(given >= 1 && given <= PartsOrder.MAX_PIECES)) {
      refuse(field, "error.pieces", PartsOrder.MAX_PIECES);
      return 1;
    }
    return given.intValue();
  }

  public int priority(String field, @Nullable Double given) {
    if (given == null) {
      return 0;
    }
    if (given != Math.rint(given) || Math.abs(given) > MAX_PRIORITY) {
      refuse(field, "error.priority.range", MAX_PRIORITY);
    }
    return given.intValue();
  }

  /** A priority that must be given. */
  public int requiredPriority(String field, @Nullable Double given) {
    if (given == null) {
      refuse(field, "error.priority.range", MAX_PRIORITY);
    }
    return priority(field, given);
  }

  public @Nullable Instant deadline(String field, @Nullable Instant given) {
    if (given != null && (given.isBefore(EARLIEST) || given.isAfter(LATEST))) {
      refuse(field, "error.deadline.range");
      return null;
    }
    return given;
  }

  /** A deadline as a person enters it: one that has passed is a slip. */
  public @Nullable Instant futureDeadline(String field, @Nullable Instant given, Instant now) {
    if (given != null && !given.isAfter(now)) {
      refuse(field, "error.deadline.past");
    }
    return deadline(field, given);
  }

  /** A moment with its offset from UTC; null where none is given. */
  public @Nullable Instant moment(String field, @Nullable String given) {
    if (given == null || given.isBlank()) {
      return null;
    }
    try {
      Instant moment = OffsetDateTime.parse(given.strip()).toInstant();
      if (!moment.isBefore(EARLIEST) && !moment.isAfter(LATEST)) {
        return moment;
      }
    } catch (DateTimeException e) {
      // the sentence below says what it should be
    }
    refuse(field, "error.moment");
    return null;
  }

  public LoadSize size(String field, @Nullable Double length, @Nullable Double width) {
    return new LoadSize(
        inRange(field + ".length", length, 0, MAX_SIDE, "error.size.missing", "error.size.range"),
        inRange(field + ".width", width, 0, MAX_SIDE, "error.size.missing", "error.size.range"));
  }

  public String robotName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    if (!ROBOT_NAME.matcher(name).matches()) {
      refuse(field, "error.robotName");
    }
    return name;
  }

  /** Of a device of the network; what robots may be called. */
  public String deviceName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    if (!ROBOT_NAME.matcher(name).matches()) {
      refuse(field, "error.deviceName");
    }
    return name;
  }

  /** How long robots wait at a stop, seconds; null where nothing is given. */
  public @Nullable Duration stopWait(String field, @Nullable Double seconds) {
    if (seconds == null) {
      return null;
    }
    if (seconds != Math.rint(seconds) || !(seconds >= 1 && seconds <= MAX_STOP_WAIT)) {
      refuse(field, "error.stopWait", MAX_STOP_WAIT);
      return null;
    }
    return Duration.ofSeconds(seconds.longValue());
  }

  /** As far as a robot charges at a stop, of 0 to 1; null where nothing is given. */
  public @Nullable Double chargeLevel(String field, @Nullable Double given) {
    if (given != null && !(given >= MIN_CHARGE && given <= 1)) { // so for NaN too
      refuse(field, "error.charge.level");
      return null;
    }
    return given;
  }

  /**
   * The number on a box.
   *
   * @param others those that other boxes have
   */
  public int boxNumber(String field, @Nullable Double given, Set<Integer> others) {
    if (given == null
        || given != Math.rint(given)
        || !(given >= 1 && given <= Integer.MAX_VALUE)
        || others.contains(given.intValue())) {
      refuse(field, "error.supervision.box");
      return 0;
    }
    return given.intValue();
  }

  /** Names of robots and what they can do, each once; empty where none are given. */
  public List<String> robotNames(String field, List<String> given) {
    List<String> names = given.stream().map(String::strip).distinct().toList();
    if (names.size() > TaskOrder.MAX_ONLY_ROBOTS) {
      refuse(field, "error.listLong", field, TaskOrder.MAX_ONLY_ROBOTS);
    } else if (!names.stream().allMatch(InputRules::isRobotOrAbility)) {
      refuse(field, "error.robotNames");
    }
    return names;
  }

  private static boolean isRobotOrAbility(String word) {
    return ROBOT_NAME.matcher(word).matches() || RobotAbility.of(word).isPresent();
  }

  public String host(String field, @Nullable String given) {
    String host = given == null ? "" : given.strip();
    if (host.length() > MAX_HOST_LENGTH || !HOST.matcher(host).matches()) {
      refuse(field, "error.host");
    }
    return host;
  }

  public int port(String field, @Nullable Double given) {
    if (given == null || given != Math.rint(given) || !(given >= 1 && given <= MAX_PORT)) {
      refuse(field, "error.port", MAX_PORT);
      return 0;
    }
    return given.intValue();
  }

  /** The gateway that reaches a robot; null where none does. */
  public @Nullable String gateway(String field, @Nullable String given) {
    if (given != null && !ROBOT_NAME.matcher(given).matches()) {
      refuse(field, "error.gateway");
    }
    return given;
  }

  /** The code that a robot shows; null where none is given. */
  public @Nullable PairingCode pairingCode(String field, @Nullable String given) {
    if (given == null) {
      return null;
    }
    Optional<PairingCode> code = PairingCode.parse(given);
    if (code.isEmpty()) {
      refuse(field, "error.code");
    }
    return code.orElse(null);
  }

  public String readingName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    if (!Topics.isReading(name) || name.equals(Topics.CONNECTION)) {
      refuse(field, "error.reading");
    }
    return name;
  }

  /** Of a reading, in whatever unit; it may be missing. */
  public @Nullable Double limit(String field, @Nullable Double given) {
    if (given != null && !(Math.abs(given) <= MAX_LIMIT)) { // so for NaN too
      refuse(field, "error.limit");
    }
    return given;
  }

  /**
   * @param field of the higher one
   */
  public void limitsInOrder(String field, @Nullable Double low, @Nullable Double high) {
    if (low != null && high != null && !(low < high)) {
      refuse(field, "error.limits.order");
    }
  }

  /** Whether a robot takes wheel commands over HTTP; else it speaks the robot link. */
  public boolean isHttp(String field, @Nullable String link) {
    boolean isHttp = HTTP.equals(link);
    if (link != null && !isHttp && !link.equals(ROBOT_LINK)) {
      refuse(field, "error.link");
    }
    return isHttp;
  }

  /** What a robot wants of the server; null where none is given. */
  public @Nullable RobotToken robotToken(String field, @Nullable String given) {
    if (given == null) {
      return null;
    }
    Optional<RobotToken> token = RobotToken.parse(given.strip());
    if (token.isEmpty()) {
      refuse(field, "error.robotToken");
    }
    return token.orElse(null);
  }

  /** Of a certificate, with or without colons; null where none is given. */
  public @Nullable Fingerprint fingerprint(String field, @Nullable String given) {
    if (given == null) {
      return null;
    }
    Optional<Fingerprint> fingerprint =
        Fingerprint.parse(given.strip().replace(":", "").toLowerCase(Locale.ROOT));
    if (fingerprint.isEmpty()) {
      refuse(field, "error.fingerprint");
    }
    return fingerprint.orElse(null);
  }

  public String userName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    if (!USER_NAME.matcher(name).matches()) {
      refuse(field, "error.userName");
    } else if (name.contains("@") && Site.isName(name.substring(name.lastIndexOf('@') + 1))) {
      refuse(field, "error.userName.site"); // or it would be in the way of who has it there
    }
    return name;
  }

  public String siteName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    if (!Site.isName(name)) {
      refuse(field, "error.siteName");
    }
    return name;
  }

  /** An e-mail address; null where none is given. */
  public @Nullable String email(String field, @Nullable String given) {
    if (given == null || given.isBlank()) {
      return null;
    }
    String email = given.strip();
    if (email.length() > MAX_EMAIL_LENGTH || !EMAIL.matcher(email).matches()) {
      refuse(field, "error.email");
    }
    return email;
  }

  /** What its owner calls a token. */
  public String tokenName(String field, @Nullable String given) {
    String name = given == null ? "" : given.strip();
    if (!GivenName.isName(name, MAX_TOKEN_NAME_LENGTH)) {
      refuse(field, "error.tokenName", MAX_TOKEN_NAME_LENGTH);
    }
    return name;
  }

  /** How many days a token is valid. */
  public int tokenDays(String field, @Nullable Double given) {
    if (given == null || given != Math.rint(given) || !(given >= 1 && given <= MAX_TOKEN_DAYS)) {
      refuse(field, "error.tokenDays", MAX_TOKEN_DAYS);
      return 1;
    }
    return given.intValue();
  }

  /** What a token may do: at least one. */
  public Set<Scope> scopes(String field, List<String> given) {
    Set<Scope> scopes = EnumSet.noneOf(Scope.class);
    given.forEach(word -> Scope.ofWord(word).ifPresent(scopes::add));
    if (given.isEmpty() || given.stream().anyMatch(word -> Scope.ofWord(word).isEmpty())) {
      refuse(field, "error.scopes");
    }
    return scopes;
  }

  /**
   * A clerk where none is given.
   *
   * @param caller who gives that role to somebody
   */
  public Role role(String field, @Nullable String given, Caller caller) {
    if (given == null) {
      return Role.CLERK;
    }
    List<Role> possible =
        Stream.of(Role.values())
            .filter(role -> role != Role.ADMINISTRATOR || caller.mayMakeAdministrators())
            .toList();
    return possible.stream()
        .filter(role -> role.name().equals(given))
        .findFirst()
        .orElseGet(
            () -> {
              refuse(
                  field,
                  "error.role",
                  possible.stream().map(Role::name).collect(Collectors.joining(", ")));
              return Role.CLERK;
            });
  }

  /** A password that somebody chooses, by {@link PasswordRules}. */
  public String newPassword(String field, @Nullable String given, String userName) {
    String password = given == null ? "" : given;
    PasswordRules.violation(password, userName)
        .ifPresent(
            violation -> {
              switch (violation) {
                case TOO_SHORT -> refuse(field, "error.password.short", PasswordRules.MIN_LENGTH);
                case TOO_LONG -> refuse(field, "error.password.long", PasswordRules.MAX_LENGTH);
                case SAME_AS_NAME -> refuse(field, "error.password.name");
                case GUESSABLE -> refuse(field, "error.password.common");
              }
            });
    return password;
  }

  private double inRange(
      String field,
      @Nullable Double given,
      double exclusiveMin,
      double max,
      String missingKey,
      String rangeKey) {
    if (given == null) {
      refuse(field, missingKey);
      return exclusiveMin;
    }
    if (!(given > exclusiveMin && given <= max)) {
      refuse(field, rangeKey, max);
    }
    return given;
  }

  private void refuse(String field, String key, Object... values) {
    errors.add(field, texts.get(key, values));
  }
}
