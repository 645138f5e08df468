package org.u2sa.cli.terminal;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.OneLine;
import org.u2sa.interfaces.time.Clock;

/**
 * Prints lines that may contain untrusted text: texts from a vehicle's services cannot start new
 * lines or control the terminal, except for colours. {@code print} is for intentional cursor
 * control.
 */
public final class PlainLines extends PrintWriter {
  // Bold, dim and the colours of text, none of which hides it on a dark terminal.
  private static final Pattern COLOUR =
      Pattern.compile("\u001b\\[(?:(?:0|1|2|21|22|3[1-79]|9[1-7])?(?:;|(?=m)))*m");

  private final Optional<Console> console;

  /** Prints to {@code out}, flushing each line. */
  public PlainLines(PrintWriter out) {
    this(out, Optional.empty());
  }

  /**
   * Prints to {@code out}, flushing each line.
   *
   * @param console the console that {@code out} belongs to, if any
   */
  public PlainLines(PrintWriter out, Optional<Console> console) {
    super(out, true);
    this.console = console;
  }

  /**
   * Prevents a vehicle's threads from waiting for the output; open it before the vehicle starts,
   * and close it after its end. Has no effect in simulated time or without a console.
   *
   * @param out output of a command
   */
  public static Console.Detached detach(PrintWriter out, Clock clock) {
    return out instanceof PlainLines lines && !clock.isSimulated()
        ? lines.console.map(Console::detach).orElse(() -> {})
        : () -> {};
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
