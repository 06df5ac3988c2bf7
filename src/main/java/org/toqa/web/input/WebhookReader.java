package org.toqa.web.input;

import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.Webhook;
import org.toqa.notices.WebhookAddresses;

/** Reads where a webhook leads ({@code url}), and of what it is told ({@code kinds}). */
public final class WebhookReader {
  private static final String URL = "url";

  private final Fields fields;
  private final WebhookAddresses addresses;

  /** What was ordered. */
  public record WebhookOrder(URI url, Set<NoticeKind> kinds) {
    public WebhookOrder {
      kinds = Set.copyOf(kinds);
    }
  }

  private WebhookReader(Fields fields, WebhookAddresses addresses) {
    this.fields = fields;
    this.addresses = addresses;
  }

  /** It means something only when no error was filed. It may wait until a name is looked up. */
  public static WebhookOrder read(Fields fields, WebhookAddresses addresses) {
    WebhookReader reader = new WebhookReader(fields, addresses);
    return new WebhookOrder(reader.url(), reader.kinds());
  }

  private Set<NoticeKind> kinds() {
    Set<NoticeKind> kinds = EnumSet.noneOf(NoticeKind.class);
    List<String> words = fields.choices("kinds");
    for (String word : words) {
      Optional<NoticeKind> kind = NoticeKind.ofWord(word);
      kind.ifPresent(kinds::add);
      if (kind.isEmpty()) {
        refuse("kinds", "error.webhooks.kind");
      }
    }
    if (words.isEmpty()) {
      refuse("kinds", "error.webhooks.kinds");
    }
    return kinds;
  }

  private URI url() {
    String given = fields.text(URL);
    URI url = given == null ? null : parsed(given.strip());
    if (url == null) {
      refuse(URL, "error.webhooks.url");
      return URI.create("https://example.org");
    }
    checkAddress(url);
    return url;
  }

  /** Null: it is no address of HTTP with a host and nothing secret or idle in it. */
  private static @Nullable URI parsed(String given) {
    try {
      URI url = new URI(given);
      String scheme = url.getScheme() == null ? "" : url.getScheme().toLowerCase(Locale.ROOT);
      boolean isRight =
          (scheme.equals("https") || scheme.equals("http"))
              && given.length() <= Webhook.LONGEST_URL
              && url.getHost() != null
              && url.getUserInfo() == null
              && url.getFragment() == null
              && url.getPort() != 0
              && url.getPort() <= 65_535;
      return isRight ? url : null;
    } catch (URISyntaxException e) {
      return null;
    }
  }

  /** The same is asked again each time when something is sent there. */
  private void checkAddress(URI url) {
    InetAddress[] found;
    try {
      String host = url.getHost();
      found =
          InetAddress.getAllByName(
              host.startsWith("[") ? host.substring(1, host.length() - 1) : host);
    } catch (UnknownHostException e) {
      refuse(URL, "error.webhooks.host");
      return;
    }
    if (!Arrays.stream(found).allMatch(addresses::allows)) {
      refuse(URL, "error.webhooks.private");
    } else if (url.getScheme().equalsIgnoreCase("http")
        && !Arrays.stream(found).allMatch(addresses::isNamed)) {
      refuse(URL, "error.webhooks.plain");
    }
  }

  private void refuse(String field, String key) {
    fields.errors().add(fields.path(field), fields.texts().get(key));
  }
}
