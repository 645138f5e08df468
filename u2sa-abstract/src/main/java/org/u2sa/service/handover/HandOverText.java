package org.u2sa.service.handover;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;

/**
 * Text file format of a {@link HandOver}: one value per line, between a header and a trailer line.
 */
public final class HandOverText {
  private static final String FIRST_WORDS = "U2SA progress 1";
  private static final String LAST_WORDS = "end";

  private HandOverText() {}

  public static List<String> lines(HandOver state, String systemId) {
    List<String> lines = new ArrayList<>();
    lines.add(String.join("\t", FIRST_WORDS, systemId, state.className()));
    state.values().forEach((name, value) -> lines.add(ProgressLine.of(name, value)));
    lines.add(LAST_WORDS);
    return lines;
  }

  public static byte[] bytes(HandOver state, String systemId) {
    return (String.join("\n", lines(state, systemId)) + "\n").getBytes(UTF_8);
  }

  /**
   * @throws IOException if the file is unreadable, incomplete, or belongs to another system; names
   *     the position
   */
  public static HandOver read(Path file, String systemId, MessageCodec codec) throws IOException {
    List<String> lines = Files.readAllLines(file, UTF_8);
    String[] first = lines.isEmpty() ? new String[0] : lines.get(0).split("\t", -1);
    int last = lines.size() - 1;
    if (first.length != 3 || !first[0].equals(FIRST_WORDS) || !lines.get(last).equals(LAST_WORDS)) {
      throw new IOException(file + ": not whole, or not the progress of a service");
    }
    if (!first[1].equals(systemId)) {
      throw new IOException(
          file + ", line 1: of system \"" + first[1] + "\", expected \"" + systemId + "\"");
    }
    HandOver state = new HandOver(first[2]);
    for (int i = 1; i < last; i++) {
      try {
        ProgressLine.readInto(state, lines.get(i), codec);
      } catch (MalformedMessageException | IllegalArgumentException e) {
        throw new IOException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
      }
    }
    return state;
  }
}
