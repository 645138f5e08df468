package org.u2sa.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

class PlainLinesTest {
  private final StringWriter text = new StringWriter();
  private final PlainLines out = new PlainLines(new PrintWriter(text));

  @Test
  void println_controlCharacters_areSpacesButForColours() {
    out.println("\u001b[31mbad\u001b[0m \u001b]0;title\u0007 a\r\nb\u2028c\u009b2J\u202ed\te");

    assertThat(text)
        .hasToString("\u001b[31mbad\u001b[0m  ]0;title  a b c 2J d\te" + System.lineSeparator());
  }

  @Test
  void println_codesThatHideText_areDropped() {
    out.println("\u001b[8mhidden\u001b[0m \u001b[1;32mshown\u001b[m \u001b[30;1mdark\u001b[40m");

    assertThat(text)
        .hasToString(
            " [8mhidden\u001b[0m \u001b[1;32mshown\u001b[m  [30;1mdark [40m"
                + System.lineSeparator());
  }

  @Test
  void printf_textsOfOthers_areOneLineAndTheFormsOwnLineEndsStay() {
    out.printf("%s:%n%d %s", "a\nb", 7, "c\u001b[2J");

    assertThat(text).hasToString("a b:" + System.lineSeparator() + "7 c [2J");
  }

  @Test
  void print_cursorCommand_isKept() {
    out.print("\u001b[H");

    out.flush();

    assertThat(text).hasToString("\u001b[H");
  }
}
