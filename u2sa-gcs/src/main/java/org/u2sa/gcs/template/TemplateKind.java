package org.u2sa.gcs.template;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;

/**
 * A kind of thing to make, as its {@code about.txt} says: a line that describes it, a line {@code
 * with: …} if it needs the files of other templates too, and what to tell at the end.
 *
 * @param name of its folder
 * @param origin where the folder is
 * @param description one line
 * @param with templates whose files it shares with others of the project
 * @param advice how to run what was made, with placeholders
 */
record TemplateKind(
    String name, String origin, String description, List<String> with, String advice) {
  private static final String WITH = "with:";

  static TemplateKind read(String name, String origin, byte[] about) {
    List<String> lines = new String(about, StandardCharsets.UTF_8).lines().toList();
    if (lines.isEmpty() || lines.get(0).isBlank()) {
      throw new BadInputException(
          origin + "/" + name + "/" + Templates.ABOUT + ": expected a description in line 1");
    }
    boolean shares = lines.size() > 1 && lines.get(1).startsWith(WITH);
    List<String> with =
        shares
            ? Stream.of(lines.get(1).substring(WITH.length()).trim().split("[ ,]+")).toList()
            : List.of();
    String advice = String.join("\n", lines.subList(shares ? 2 : 1, lines.size())).strip();
    return new TemplateKind(name, origin, lines.get(0), with, advice);
  }
}
