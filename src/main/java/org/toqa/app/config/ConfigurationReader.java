package org.toqa.app.config;

import ch.qos.logback.classic.Level;
import java.io.File;
import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.PasswordHasher;
import org.toqa.accounts.PasswordRules;
import org.toqa.agent.config.Avoidance;
import org.toqa.allocation.Policy;
import org.toqa.app.config.Configuration.DatabaseSettings;
import org.toqa.app.config.Configuration.FirstManager;
import org.toqa.app.config.Configuration.Limits;
import org.toqa.app.config.Configuration.LogFormat;
import org.toqa.app.config.Configuration.MailSecurity;
import org.toqa.app.config.Configuration.MailServer;
import org.toqa.app.config.Configuration.TlsFiles;
import org.toqa.app.config.ValueRange.Choice;
import org.toqa.app.config.ValueRange.Decimal;
import org.toqa.app.config.ValueRange.WholeNumber;
import org.toqa.app.config.ValueRange.WholeNumbers;
import org.toqa.fleet.ChargingRules;
import org.toqa.grid.Margins;
import org.toqa.network.DhcpSettings;
import org.toqa.network.Subnet;
import org.toqa.notices.WebhookAddresses;
import org.toqa.store.Database;
import org.toqa.telemetry.mqtt.BrokerSettings;

/**
 * Reads a configuration and checks every value.
 *
 * @param layers the first one that gives a setting decides
 */
record ConfigurationReader(List<SettingSource> layers) {
  private static final String BROKER =
      "mqtts?://(\\[[0-9A-Fa-f:.]+\\]|[A-Za-z0-9._-]+)(:[0-9]{1,5})?";
  private static final int LARGEST_PORT = 65_535;
  private static final String URL = "https?://[^\\s/?#]+(/[^\\s?#]*)?";

  /**
   * @param shippedMap the floor's map where none is configured
   * @throws ConfigurationException a value cannot be used; names it and what it must be
   */
  Configuration read(Path shippedMap) throws ConfigurationException {
    Path data = folder(Setting.DATA);
    List<Integer> simulate = wholeNumbers(Setting.SIMULATE);
    boolean isSimulated = simulate.stream().anyMatch(count -> count > 0);
    Duration lostAfter = Duration.ofSeconds(wholeNumber(Setting.LOST_AFTER));
    double speed = number(Setting.SPEED);
    if (speed != 1 && !isSimulated) {
      throw invalid(
          Setting.SPEED, "only simulated robots can be made faster: set simulate as well.");
    }
    return new Configuration(
        address(Setting.ADDRESS),
        wholeNumber(Setting.PORT),
        hosts(),
        tls(),
        proxy(),
        wholeNumber(Setting.REQUESTS_PER_SECOND),
        limits(),
        Duration.ofHours(wholeNumber(Setting.SESSION_HOURS)),
        data,
        maps(shippedMap),
        shippedMap,
        database(data),
        allocationPolicy(),
        simulate,
        batteries(),
        avoidance(isSimulated),
        boxes(isSimulated),
        firmware(isSimulated),
        number(Setting.WIDEST_ROBOT),
        new Margins(number(Setting.MARGINS_ROBOT), number(Setting.MARGINS_FORMATION)),
        lostAfter,
        charging(),
        speed,
        Duration.ofDays(wholeNumber(Setting.KEEP_TRACKS)),
        Duration.ofDays(wholeNumber(Setting.KEEP_HISTORY)),
        firstManager(),
        mailServer(),
        webhooks(),
        flag(Setting.PLAIN_LINKS),
        gateways(),
        broker(),
        dhcp(),
        logLevel(),
        logFormat(),
        settings());
  }

  private List<ConfiguredSetting> settings() {
    return Arrays.stream(Setting.values()).map(this::configured).toList();
  }

  private ConfiguredSetting configured(Setting setting) {
    boolean isGiven = layers.stream().anyMatch(layer -> layer.value(setting) != null);
    String text = text(setting);
    return new ConfiguredSetting(
        setting.key(),
        setting.isSecret() && !text.isEmpty() ? null : withoutSecrets(setting, text),
        isGiven ? value(setting).origin() : null,
        setting.allowedValues());
  }

  /** The address of a database may have its password in it, behind a question mark or semicolon. */
  private static String withoutSecrets(Setting setting, String text) {
    return setting == Setting.DATABASE_URL
        ? text.replaceFirst("[?;].*", "...").replaceFirst("//[^/@]*@", "//...@")
        : text;
  }

  private Limits limits() throws ConfigurationException {
    return new Limits(
        wholeNumber(Setting.REQUESTS_AT_ONCE),
        wholeNumber(Setting.CHECKS_PER_USER),
        wholeNumber(Setting.STREAMS_PER_USER),
        wholeNumber(Setting.STREAMS_PER_ADDRESS),
        wholeNumber(Setting.CONNECTIONS),
        wholeNumber(Setting.CONNECTIONS_PER_ADDRESS),
        Duration.ofSeconds(wholeNumber(Setting.REQUEST_SECONDS)),
        wholeNumber(Setting.SESSIONS_PER_USER));
  }

  private List<Double> batteries() throws ConfigurationException {
    return wholeNumbers(Setting.SIMULATE_BATTERIES).stream()
        .map(percent -> percent / 100.0)
        .toList();
  }

  /** With commas between. */
  private List<Integer> wholeNumbers(Setting setting) throws ConfigurationException {
    List<Integer> numbers = new ArrayList<>();
    for (String word : text(setting).split(",", -1)) {
      if (!word.strip().matches("0|[1-9][0-9]{0,2}")) {
        throw outOfRange(setting);
      }
      int number = Integer.parseInt(word.strip());
      if (!(setting.range() instanceof WholeNumbers range && range.contains(number))) {
        throw outOfRange(setting);
      }
      numbers.add(number);
    }
    return List.copyOf(numbers);
  }

  private ChargingRules charging() throws ConfigurationException {
    int below = wholeNumber(Setting.CHARGING_BELOW);
    int until = wholeNumber(Setting.CHARGING_UNTIL);
    if (until <= below) {
      throw invalid(
          Setting.CHARGING_UNTIL, "it must be more than charging.below, which is " + below + ".");
    }
    return new ChargingRules(
        below / 100.0,
        until / 100.0,
        Duration.ofSeconds(Math.round(3600 * number(Setting.CHARGING_AFTER_HOURS))),
        Duration.ofMinutes(wholeNumber(Setting.CHARGING_MINUTES)),
        ChargingRules.USUAL.patience());
  }

  private InetAddress address(Setting setting) throws ConfigurationException {
    try {
      return LocalAddress.parse(text(setting));
    } catch (UnknownHostException e) {
      throw outOfRange(setting);
    }
  }

  private @Nullable GatewaySettings gateways() throws ConfigurationException {
    InetAddress address = address(Setting.GATEWAYS_ADDRESS);
    int port = wholeNumber(Setting.GATEWAYS_PORT);
    String trusted = text(Setting.GATEWAYS_TRUSTED).strip();
    if (trusted.isEmpty()) {
      return null;
    }
    return GatewaySettings.parseTrusted(trusted)
        .map(known -> new GatewaySettings(address, port, known))
        .orElseThrow(() -> outOfRange(Setting.GATEWAYS_TRUSTED));
  }

  private @Nullable BrokerSettings broker() throws ConfigurationException {
    InetAddress address = address(Setting.MQTT_ADDRESS);
    int port = wholeNumber(Setting.MQTT_PORT);
    boolean plain = flag(Setting.MQTT_PLAIN);
    String broker = text(Setting.MQTT_BROKER).strip();
    if (broker.isEmpty()) {
      return null;
    }
    if (!broker.equals("embedded")) {
      return externalBroker(plain);
    }
    if (text(Setting.MQTT_CERTIFICATE).isEmpty() && text(Setting.MQTT_KEY).isEmpty()) {
      requirePlain(Setting.MQTT_ADDRESS, address, plain, "give mqtt.certificate and mqtt.key");
      return new BrokerSettings.Embedded(address, port, null);
    }
    return new BrokerSettings.Embedded(
        address,
        port,
        new BrokerSettings.PemFiles(pem(Setting.MQTT_CERTIFICATE), pem(Setting.MQTT_KEY)));
  }

  private @Nullable DhcpSettings dhcp() throws ConfigurationException {
    if (choice(Setting.DHCP_SERVER).equals("none")) {
      return null;
    }
    Subnet subnet =
        Subnet.parse(text(Setting.DHCP_SUBNET).strip())
            .orElseThrow(() -> outOfRange(Setting.DHCP_SUBNET));
    Path hosts = path(Setting.DHCP_HOSTS);
    Path folder = hosts.getParent();
    if (folder == null || !Files.isWritable(folder) || Files.isDirectory(hosts)) {
      throw invalid(
          Setting.DHCP_HOSTS, "it must be a file in a folder that this server may write to.");
    }
    return new DhcpSettings(
        subnet,
        hosts,
        path(Setting.DHCP_LEASES),
        text(Setting.DHCP_PID).isEmpty() ? null : path(Setting.DHCP_PID));
  }

  private BrokerSettings externalBroker(boolean plain) throws ConfigurationException {
    URI uri = URI.create(matching(Setting.MQTT_BROKER, BROKER));
    int port = uri.getPort();
    if (uri.getHost() == null || port == 0 || port > LARGEST_PORT) {
      throw outOfRange(Setting.MQTT_BROKER);
    }
    if (uri.getScheme().equals("mqtt")) {
      InetAddress host;
      try {
        host = InetAddress.getByName(uri.getHost());
      } catch (UnknownHostException e) {
        host = InetAddress.ofLiteral("0.0.0.0"); // it may be known later; it is not loopback
      }
      requirePlain(Setting.MQTT_BROKER, host, plain, "use mqtts://");
    }
    return new BrokerSettings.External(
        uri,
        nullIfEmpty(text(Setting.MQTT_USER)),
        nullIfEmpty(text(Setting.MQTT_PASSWORD)),
        text(Setting.MQTT_CA).isEmpty() ? null : pem(Setting.MQTT_CA));
  }

  /** Passwords go unencrypted nowhere but on loopback, unless somebody says so by name. */
  private void requirePlain(Setting setting, InetAddress address, boolean plain, String remedy)
      throws ConfigurationException {
    if (!plain && !address.isLoopbackAddress()) {
      throw invalid(
          setting,
          "passwords would go there unencrypted: %s, or set mqtt.plain to true.".formatted(remedy));
    }
  }

  /** With those that {@link Setting#ADDRESS} and {@link Setting#URL} name. */
  private Set<String> hosts() throws ConfigurationException {
    Set<String> hosts = new TreeSet<>();
    hosts.add(text(Setting.ADDRESS).strip());
    for (String name : text(Setting.HOSTS).split(",", -1)) {
      if (!name.strip().matches("[A-Za-z0-9._-]*")) {
        throw outOfRange(Setting.HOSTS);
      }
      hosts.add(name.strip());
    }
    String url = text(Setting.URL).strip();
    if (!url.isEmpty()) {
      String host = URI.create(matching(Setting.URL, URL)).getHost();
      hosts.add(host == null ? "" : host);
    }
    hosts.remove("");
    return Set.copyOf(hosts);
  }

  private @Nullable TlsFiles tls() throws ConfigurationException {
    if (text(Setting.TLS_CERTIFICATE).isEmpty() && text(Setting.TLS_KEY).isEmpty()) {
      return null;
    }
    return new TlsFiles(pem(Setting.TLS_CERTIFICATE), pem(Setting.TLS_KEY));
  }

  private Path pem(Setting setting) throws ConfigurationException {
    if (text(setting).isEmpty()) {
      throw outOfRange(setting);
    }
    Path file = path(setting);
    if (!Files.isRegularFile(file) || !Files.isReadable(file)) {
      throw invalid(setting, "there is no such file that can be read.");
    }
    return file;
  }

  private @Nullable InetAddress proxy() throws ConfigurationException {
    String text = text(Setting.PROXY).strip();
    try {
      return text.isEmpty() ? null : InetAddress.ofLiteral(text);
    } catch (IllegalArgumentException e) {
      throw outOfRange(Setting.PROXY);
    }
  }

  private int wholeNumber(Setting setting) throws ConfigurationException {
    int number = parsed(setting, Integer::valueOf);
    if (!(setting.range() instanceof WholeNumber range && range.contains(number))) {
      throw outOfRange(setting);
    }
    return number;
  }

  private double number(Setting setting) throws ConfigurationException {
    double number = parsed(setting, Double::valueOf);
    if (!(setting.range() instanceof Decimal range && range.contains(number))) {
      throw outOfRange(setting);
    }
    return number;
  }

  /** One of the words that the setting may have. */
  private String choice(Setting setting) throws ConfigurationException {
    String word = text(setting).strip();
    if (!(setting.range() instanceof Choice choice && choice.words().contains(word))) {
      throw outOfRange(setting);
    }
    return word;
  }

  private <T> T parsed(Setting setting, Function<String, T> parser) throws ConfigurationException {
    try {
      return parser.apply(text(setting).strip());
    } catch (NumberFormatException e) {
      throw outOfRange(setting);
    }
  }

  private Path folder(Setting setting) throws ConfigurationException {
    Path folder = path(setting);
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw invalid(setting, "this is a file; it must be a folder.");
    }
    Path present = folder;
    while (!Files.exists(present) && present.getParent() != null) {
      present = present.getParent();
    }
    if (!Files.isWritable(present)) {
      throw invalid(setting, "nothing can be written to " + present + "; name another folder.");
    }
    return folder;
  }

  private Avoidance avoidance(boolean isSimulated) throws ConfigurationException {
    Setting setting = Setting.SIMULATE_AVOIDANCE;
    Avoidance avoidance =
        Stream.of(Avoidance.values())
            .filter(each -> each.word().equals(text(setting)))
            .findFirst()
            .orElseThrow(() -> outOfRange(setting));
    if (avoidance != Avoidance.FOUR_AGENTS) {
      return avoidance;
    }
    if (!isSimulated) {
      throw invalid(setting, "only simulated robots avoid so by it: set simulate as well.");
    }
    if (!text(Setting.FIRMWARE).isEmpty()) {
      throw invalid(setting, "robots of the firmware have no eight range sensors: leave one out.");
    }
    return avoidance;
  }

  private @Nullable Path boxes(boolean isSimulated) throws ConfigurationException {
    if (text(Setting.SIMULATE_BOXES).isEmpty()) {
      return null;
    }
    if (!isSimulated) {
      throw invalid(
          Setting.SIMULATE_BOXES, "only simulated robots find them: set simulate as well.");
    }
    Path file = path(Setting.SIMULATE_BOXES);
    if (!Files.isReadable(file) || Files.isDirectory(file)) {
      throw outOfRange(Setting.SIMULATE_BOXES);
    }
    return file;
  }

  private @Nullable Path firmware(boolean isSimulated) throws ConfigurationException {
    if (text(Setting.FIRMWARE).isEmpty()) {
      return null;
    }
    if (!isSimulated) {
      throw invalid(Setting.FIRMWARE, "only simulated robots need it: set simulate as well.");
    }
    Path folder = path(Setting.FIRMWARE);
    if (!Files.isExecutable(folder.resolve("toqa-sim"))) {
      throw outOfRange(Setting.FIRMWARE);
    }
    return folder;
  }

  /** A file, or several with colons between, as in a search path. */
  private List<Path> maps(Path shipped) throws ConfigurationException {
    String text = text(Setting.MAP);
    if (text.isEmpty()) {
      return List.of(shipped);
    }
    List<Path> files = new ArrayList<>();
    String[] words =
        Files.exists(path(Setting.MAP)) ? new String[] {text} : text.split(File.pathSeparator, -1);
    for (String word : words) {
      Path file = path(Setting.MAP, word);
      if (!file.toString().matches(".*\\.(yaml|map)")) {
        throw outOfRange(Setting.MAP);
      }
      if (!Files.isReadable(file)) {
        throw invalid(Setting.MAP, "there is no such file that can be read.");
      }
      files.add(file);
    }
    return List.copyOf(files);
  }

  private Path path(Setting setting) throws ConfigurationException {
    return path(setting, value(setting).text());
  }

  private Path path(Setting setting, String text) throws ConfigurationException {
    if (text.isBlank()) {
      throw outOfRange(setting);
    }
    try {
      return value(setting).folder().resolve(text).toAbsolutePath().normalize();
    } catch (InvalidPathException e) {
      throw outOfRange(setting);
    }
  }

  private DatabaseSettings database(Path data) throws ConfigurationException {
    String url = text(Setting.DATABASE_URL);
    if (url.isEmpty()) {
      return new DatabaseSettings(Database.fileUrl(data.resolve("toqa")), null, null);
    }
    if (!Database.isSupported(url)) {
      throw outOfRange(Setting.DATABASE_URL);
    }
    return new DatabaseSettings(
        url,
        nullIfEmpty(text(Setting.DATABASE_USER)),
        nullIfEmpty(text(Setting.DATABASE_PASSWORD)));
  }

  private Policy allocationPolicy() throws ConfigurationException {
    String word = choice(Setting.ALLOCATOR);
    return Arrays.stream(Policy.values())
        .filter(policy -> policy.word().equals(word))
        .findFirst()
        .orElseThrow(() -> outOfRange(Setting.ALLOCATOR));
  }

  private @Nullable FirstManager firstManager() throws ConfigurationException {
    String text = text(Setting.MANAGER);
    if (text.isEmpty()) {
      return null;
    }
    int colon = text.indexOf(':');
    if (colon < 1 || colon == text.length() - 1) {
      throw outOfRange(Setting.MANAGER);
    }
    String password = text.substring(colon + 1);
    if (password.startsWith("$argon2") && !PasswordHasher.isHash(password)) {
      throw outOfRange(Setting.MANAGER);
    }
    String name = text.substring(0, colon);
    if (!PasswordHasher.isHash(password) && PasswordRules.violation(password, name).isPresent()) {
      throw invalid(
          Setting.MANAGER,
          "the password must have %d to %d characters, and be none that is guessed first."
              .formatted(PasswordRules.MIN_LENGTH, PasswordRules.MAX_LENGTH));
    }
    return new FirstManager(name, password);
  }

  private @Nullable MailServer mailServer() throws ConfigurationException {
    String host = text(Setting.MAIL_HOST).strip();
    if (host.isEmpty()) {
      return null;
    }
    return new MailServer(
        host,
        wholeNumber(Setting.MAIL_PORT),
        mailSecurity(),
        nullIfEmpty(text(Setting.MAIL_USER)),
        nullIfEmpty(text(Setting.MAIL_PASSWORD)),
        ofMail(Setting.MAIL_FROM, "[^\\s@<>,;]+@[^\\s@<>,;]+"),
        ofMail(Setting.URL, URL).replaceFirst("/+$", ""));
  }

  /** What is needed where there is a mail server, which is where somebody left it out. */
  private String ofMail(Setting setting, String pattern) throws ConfigurationException {
    if (text(setting).isBlank()) {
      throw invalid(
          Setting.MAIL_HOST, "%s must be %s.".formatted(setting.key(), setting.allowedValues()));
    }
    return matching(setting, pattern);
  }

  private WebhookAddresses webhooks() throws ConfigurationException {
    List<WebhookAddresses.Network> networks = new ArrayList<>();
    String given = text(Setting.WEBHOOKS_NETWORKS).strip();
    for (String word : given.isEmpty() ? new String[0] : given.split(",", -1)) {
      networks.add(
          WebhookAddresses.Network.parse(word)
              .orElseThrow(() -> outOfRange(Setting.WEBHOOKS_NETWORKS)));
    }
    return new WebhookAddresses(networks);
  }

  private MailSecurity mailSecurity() throws ConfigurationException {
    return MailSecurity.valueOf(choice(Setting.MAIL_SECURITY).toUpperCase(Locale.ROOT));
  }

  private String matching(Setting setting, String pattern) throws ConfigurationException {
    String text = text(setting).strip();
    if (!text.matches(pattern)) {
      throw outOfRange(setting);
    }
    return text;
  }

  private boolean flag(Setting setting) throws ConfigurationException {
    return Boolean.parseBoolean(choice(setting));
  }

  private LogFormat logFormat() throws ConfigurationException {
    return LogFormat.valueOf(choice(Setting.LOG_FORMAT).toUpperCase(Locale.ROOT));
  }

  private Level logLevel() throws ConfigurationException {
    String word = text(Setting.LOG_LEVEL).toUpperCase(Locale.ROOT);
    if (!(Setting.LOG_LEVEL.range() instanceof Choice choice && choice.words().contains(word))) {
      throw outOfRange(Setting.LOG_LEVEL);
    }
    return Level.valueOf(word);
  }

  private String text(Setting setting) {
    return value(setting).text();
  }

  private SettingSource.Value value(Setting setting) {
    for (SettingSource layer : layers) {
      SettingSource.Value value = layer.value(setting);
      if (value != null) {
        return value;
      }
    }
    return new SettingSource.Value(setting.defaultValue(), setting.key(), Path.of(""));
  }

  private ConfigurationException outOfRange(Setting setting) {
    return invalid(setting, "it must be " + setting.allowedValues() + ".");
  }

  private ConfigurationException invalid(Setting setting, String remedy) {
    SettingSource.Value value = value(setting);
    String shown = setting.isSecret() ? "" : " \"" + abbreviated(value.text()) + "\"";
    return new ConfigurationException(value.origin() + shown + ": " + remedy);
  }

  private static String abbreviated(String text) {
    return text.length() <= 100 ? text : text.substring(0, 100) + "...";
  }

  private static @Nullable String nullIfEmpty(String text) {
    return text.isEmpty() ? null : text;
  }
}
