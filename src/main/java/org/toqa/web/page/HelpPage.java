package org.toqa.web.page;

import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;
import org.toqa.web.RequestPath;

/** The documents, as they are written, for who stands before a form ({@code help.tag}). */
public final class HelpPage extends PageHandler {
  /** What people who use the pages look for, in the order in which the list shows it. */
  private static final List<String> TOPICS =
      List.of(
          "tasks",
          "maps",
          "users",
          "notices",
          "history",
          "statistics",
          "allocation",
          "formation",
          "charging",
          "control",
          "arm",
          "supervision",
          "robot",
          "robot-link",
          "http-robot",
          "gateway",
          "telemetry",
          "network",
          "cameras",
          "laboratory",
          "configuration",
          "operations",
          "security",
          "languages",
          "glossary");

  private static final List<Extension> EXTENSIONS =
      List.of(TablesExtension.create(), HeadingAnchorExtension.create());
  private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();
  private static final HtmlRenderer RENDERER =
      HtmlRenderer.builder().extensions(EXTENSIONS).escapeHtml(true).sanitizeUrls(true).build();
  private static final Pattern TITLE = Pattern.compile("# (.+)");
  private static final Pattern DOCUMENT = Pattern.compile("([a-z-]+)\\.md(#.*)?");

  /** A document in the list. */
  public record Topic(String name, String title) {}

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    ServletContext context = request.getServletContext();
    request.setAttribute(
        "topics",
        TOPICS.stream()
            .flatMap(
                name -> document(context, name).map(text -> new Topic(name, title(text))).stream())
            .toList());
    show(request, response, "help");
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<String> document =
        document(request.getServletContext(), RequestPath.parameter(request, "topic"));
    if (document.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchPage");
      return;
    }
    Node root = PARSER.parse(document.get());
    root.accept(new Links(request));
    request.setAttribute("documentTitle", title(document.get()));
    request.setAttribute("document", RENDERER.render(root));
    show(request, response, "help");
  }

  private static Optional<String> document(ServletContext context, String name) {
    if (!name.matches("[a-z-]+")) {
      return Optional.empty();
    }
    try (InputStream document = context.getResourceAsStream("/WEB-INF/docs/" + name + ".md")) {
      return document == null
          ? Optional.empty()
          : Optional.of(new String(document.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      return Optional.empty(); // it is not there to be read
    }
  }

  private static String title(String document) {
    Matcher title = TITLE.matcher(document);
    return title.lookingAt() ? title.group(1) : "";
  }

  /** Links to other documents lead to their pages; what only the sources have is no link. */
  private static final class Links extends AbstractVisitor {
    private final HttpServletRequest request;

    Links(HttpServletRequest request) {
      this.request = request;
    }

    @Override
    public void visit(Link link) {
      visitChildren(link);
      String to = link.getDestination();
      Matcher document = DOCUMENT.matcher(to);
      if (document.matches()
          && document(request.getServletContext(), document.group(1)).isPresent()) {
        String section = document.group(2);
        link.setDestination(
            request.getContextPath()
                + "/help/"
                + document.group(1)
                + (section == null ? "" : section));
      } else if (!to.startsWith("#") && !to.startsWith("https://")) {
        Node after = link;
        for (Node child = link.getFirstChild(); child != null; child = link.getFirstChild()) {
          after.insertAfter(child);
          after = child;
        }
        link.unlink();
      }
    }

    @Override
    public void visit(Image image) {
      image.unlink();
    }
  }
}
