package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.Part;
import java.io.IOException;
import java.io.InputStream;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.TaskView;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.LineFaults;
import org.toqa.web.input.TaskImport;
import org.toqa.web.input.TemplateFiller;

/** Puts in many tasks at once, from a table that a spreadsheet has saved. */
public final class ImportPage extends PageHandler {
  private static final String FILE = "file";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute("idempotencyKey", UUID.randomUUID());
    show(request, response, "import");
  }

  public static void submit(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<List<TaskView>> tasks;
    try {
      tasks = importTable(request, errors);
    } catch (CheckRefusedException e) {
      request.setAttribute("idempotencyKey", UUID.randomUUID());
      showRefused(request, response, "import", FILE, e);
      return;
    }
    if (tasks.isPresent()) {
      redirect(request, response, "/tasks?imported=" + tasks.get().size());
    } else {
      request.setAttribute("idempotencyKey", UUID.randomUUID());
      showAgain(request, response, "import", errors);
    }
  }

  private static Optional<List<TaskView>> importTable(
      HttpServletRequest request, FieldErrors errors) throws ServletException, IOException {
    Texts texts = Texts.of(request);
    byte[] table = table(request);
    Optional<ZoneId> zone = TaskImport.zone(request.getParameter("zone"));
    if (table.length == 0) {
      errors.add(FILE, texts.get("error.import.noFile"));
    } else if (table.length > TaskImport.MAX_BYTES) {
      errors.add(FILE, texts.get("error.import.large", TaskImport.MAX_BYTES / 1024));
    } else if (zone.isEmpty()) {
      errors.add(FILE, texts.get("error.statistics.zone"));
    }
    return errors.isEmpty()
        ? importTable(table, zone.orElseThrow(), request, errors)
        : Optional.empty();
  }

  private static Optional<List<TaskView>> importTable(
      byte[] table, ZoneId zone, HttpServletRequest request, FieldErrors errors) {
    Account user = Caller.of(request).account();
    UUID key =
        IdempotentSubmitter.idempotencyKey(
            user, "import " + request.getParameter("idempotencyKey"));
    TemplateFiller templates = TemplateFiller.of(Caller.of(request), services(request).templates());
    return switch (new TaskImport(services(request), Texts.of(request), templates)
        .run(table, zone, user, key)) {
      case TaskImport.Outcome.Imported(List<TaskView> tasks) -> Optional.of(tasks);
      case TaskImport.Outcome.Faulty(LineFaults faults) -> {
        request.setAttribute("faults", faults);
        errors.add(FILE, Texts.of(request).get("import.faulty"));
        yield Optional.empty();
      }
      case TaskImport.Outcome.KeyReused() -> {
        errors.add(FILE, Texts.of(request).get("error.import.again"));
        yield Optional.empty();
      }
    };
  }

  /** As much of it as tells whether it is too large. Nothing where no file was chosen. */
  private static byte[] table(HttpServletRequest request) throws ServletException, IOException {
    Part part = isMultipart(request.getContentType()) ? request.getPart(FILE) : null;
    if (part == null) {
      return new byte[0];
    }
    try (InputStream file = part.getInputStream()) {
      return file.readNBytes(TaskImport.MAX_BYTES + 1);
    }
  }

  private static boolean isMultipart(@Nullable String contentType) {
    return contentType != null && contentType.startsWith("multipart/form-data");
  }
}
