package org.u2sa.scenarios.report;

import java.awt.Color;
import java.awt.Font;
import java.util.List;
import org.u2sa.scenarios.report.Drawing.Pen;
import org.u2sa.scenarios.report.Drawing.Type;

/**
 * Colours and type of the track picture; the accents are Okabe and Ito's, told apart with any
 * colour vision.
 */
final class Ink {
  private static final List<String> FAMILIES =
      List.of("Liberation Sans", "Arial", "Helvetica", "DejaVu Sans");

  static final Color PAPER = Color.WHITE;
  static final Color PANEL = new Color(0xf6f7f9);
  static final Color PANEL_VEIL = new Color(0xf6, 0xf7, 0xf9, 0xd0);
  static final Color TEXT = new Color(0x1d2430);
  static final Color MUTED = new Color(0x667080);
  static final Color FAINT = new Color(0xdfe3e9);
  static final Color PLANNED = new Color(0x9aa3b0);
  static final Color CAPTURED = new Color(0x009e73);
  static final Color CAPTURED_AREA = new Color(0x00, 0x9e, 0x73, 0x24);
  static final Color MISSED = new Color(0xd55e00);
  static final Color MISSED_AREA = new Color(0xd5, 0x5e, 0x00, 0x24);
  static final Color HOME = new Color(0x3a4250);
  static final Color FLOWN_AREA = new Color(0x31, 0x68, 0x8e, 0x20);

  static final Pen GRID = Pen.solid(FAINT, 1.0);
  static final Pen FRAME = Pen.solid(PLANNED, 1.2);

  static final Type TITLE = type(TEXT, Font.BOLD, 34);
  static final Type SUBTITLE = type(MUTED, Font.PLAIN, 19);
  static final Type ALARM = type(MISSED, Font.BOLD, 19);
  static final Type HEADING = type(TEXT, Font.BOLD, 17);
  static final Type LABEL = type(TEXT, Font.BOLD, 16);
  static final Type TICK = type(MUTED, Font.PLAIN, 14);

  private Ink() {}

  private static Type type(Color color, int style, int size) {
    String family =
        FAMILIES.stream()
            .filter(name -> new Font(name, style, 1).getFamily().equals(name)) // else Java's Dialog
            .findFirst()
            .orElse(Font.SANS_SERIF);
    return new Type(color, new Font(family, style, size));
  }
}
