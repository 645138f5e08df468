package org.u2sa.report.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.u2sa.interfaces.JsonText;
import org.u2sa.report.EscapedXml;
import org.u2sa.report.ReportFile;

/** Writes the page: a template with embedded style and script, and the runs as JSON. */
public final class RunPage {
  private static final List<String> PARTS = List.of("page.css", "page.js");

  private RunPage() {}

  /**
   * Writes the page atomically.
   *
   * @param runs name, durationS, figures, charts, timeline and facts of each; map and latency are
   *     optional
   * @throws org.u2sa.interfaces.RunFailedException if it cannot be written
   */
  public static void write(Path file, String title, List<JsonText> runs) {
    String data = inScript(new JsonText().put("title", title).put("runs", runs).line());
    String page = resource("page.html");
    for (String part : PARTS) {
      page = page.replace("{{" + part + "}}", resource(part));
    }
    String whole = page.replace("{{title}}", EscapedXml.of(title)).replace("{{data}}", data);
    ReportFile.writeText(file, out -> out.write(whole));
  }

  /** JSON that is safe inside a script element: no contained text can end it or start a comment. */
  static String inScript(String json) {
    return json.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029");
  }

  private static String resource(String name) {
    try (InputStream in = RunPage.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException(name + " is missing: incomplete build");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(name, e);
    }
  }
}
