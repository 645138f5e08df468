package org.u2sa.cli.terminal;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.OneLine;

/**
 * Prints lines that may contain untrusted text: texts from a vehicle's services cannot start new
 * lines or control the terminal, except for colours. {@code print} is for intentional cursor
 * control.
 */
public final class PlainLines extends PrintWriter {
  // Bold, dim and the colours of text, none of which hides it on a dark terminal.
  private static final Pattern COLOUR =
      Pattern.compile("\u001b\\[(?:(?:0|1|2|21|22|3[1-79]|9[1-7])?(?:;|(?=m)))*m");

  /** Prints to {@code out}, flushing each line. */
  public PlainLines(PrintWriter out) {
    super(out, true);
  }

  @Override
  public void println(String line) {
    super.println(plain(String.valueOf(line)));
  }

  @Override
  public PrintWriter printf(String form, Object... values) {
    Object[] plain =
        Arrays.stream(values)
            .map(value -> value instanceof String text ? plain(text) : value)
            .toArray();
    return super.printf(form, plain);
  }

  private static String plain(String text) {
    StringBuilder plain = new StringBuilder();
    Matcher colour = COLOUR.matcher(text);
    int at = 0;
    while (colour.find()) {
      plain.append(OneLine.of(text.substring(at, colour.start()))).append(colour.group());
      at = colour.end();
    }
    return plain.append(OneLine.of(text.substring(at))).toString();
  }
}
