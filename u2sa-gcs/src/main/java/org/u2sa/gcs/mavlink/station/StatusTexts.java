package org.u2sa.gcs.mavlink.station;

import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.Statustext;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Splits texts into STATUSTEXT messages of 50 bytes, which stations join by ID and sequence. */
public final class StatusTexts {
  private static final int CHUNK = 50;
  private static final int MAX_CHUNKS = 10;
  private static final int IDS = 0xFFFF;

  private int id;

  /** Messages that carry a text; beyond 500 bytes it is cut off. */
  public List<Statustext> of(MavSeverity severity, String text) {
    String ascii = ascii(text);
    List<Statustext> messages = new ArrayList<>();
    boolean isWhole = ascii.length() <= CHUNK;
    id = isWhole ? id : id % IDS + 1;
    for (int chunk = 0;
        chunk < MAX_CHUNKS && chunk * CHUNK < Math.max(1, ascii.length());
        chunk++) {
      int from = chunk * CHUNK;
      messages.add(
          Statustext.builder()
              .severity(severity)
              .text(ascii.substring(from, Math.min(ascii.length(), from + CHUNK)))
              .id(isWhole ? 0 : id)
              .chunkSeq(chunk)
              .build());
    }
    return messages;
  }

  /** Stations differ in how they decode other characters. */
  private static String ascii(String text) {
    String plain =
        text.replace('…', '-')
            .replace('–', '-')
            .replace('“', '"')
            .replace('”', '"')
            .replace("°", " deg")
            .replace("²", "2")
            .replace("µ", "u");
    return new String(plain.getBytes(StandardCharsets.US_ASCII), StandardCharsets.US_ASCII);
  }
}
