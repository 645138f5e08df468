package org.u2sa.scenarios.report;

import java.awt.Color;
import org.u2sa.gcs.draw.Stroke;
import org.u2sa.gcs.draw.TextStyle;

/**
 * Colours and type of the track picture; the accents are Okabe and Ito's, told apart with any
 * colour vision.
 */
final class Ink {

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
  static final Color RUNWAY = new Color(0x3a4250);
  static final Color FLOWN_AREA = new Color(0x31, 0x68, 0x8e, 0x20);

  static final Stroke GRID = Stroke.solid(FAINT, 1.0);
  static final Stroke FRAME = Stroke.solid(PLANNED, 1.2);

  static final TextStyle TITLE = TextStyle.of(TEXT, 34).inBold();
  static final TextStyle SUBTITLE = TextStyle.of(MUTED, 19);
  static final TextStyle ALARM = TextStyle.of(MISSED, 19).inBold();
  static final TextStyle HEADING = TextStyle.of(TEXT, 17).inBold();
  static final TextStyle LABEL = TextStyle.of(TEXT, 16).inBold();
  static final TextStyle TICK = TextStyle.of(MUTED, 14);

  private Ink() {}
}
