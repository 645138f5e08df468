package org.u2sa.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Map;
import org.junit.jupiter.api.Test;

class TerminalTest {

  private final StringWriter text = new StringWriter();
  private final PrintWriter out = new PrintWriter(text);

  @Test
  void of_interactive_redrawsInColour() {
    Terminal terminal = Terminal.of(out, true, Map.of("TERM", "xterm", "COLUMNS", "120"));
    assertThat(terminal).isEqualTo(new Terminal(out, true, true, 120));
  }

  @Test
  void of_noColor_redrawsWithoutColour() {
    Terminal terminal = Terminal.of(out, true, Map.of("TERM", "xterm", "NO_COLOR", "1"));
    assertThat(terminal).isEqualTo(new Terminal(out, true, false, 80));
  }

  @Test
  void of_dumbOrPiped_isPlain() {
    assertThat(Terminal.of(out, true, Map.of("TERM", "dumb")))
        .isEqualTo(new Terminal(out, false, false, 80));
    assertThat(Terminal.of(out, false, Map.of("TERM", "xterm", "COLUMNS", "wide")))
        .isEqualTo(new Terminal(out, false, false, 80));
  }
}
