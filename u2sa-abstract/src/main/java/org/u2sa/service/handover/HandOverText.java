package org.u2sa.service.handover;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/**
 * Text file format of a {@link HandOver}, between a header and a trailer line: one value per
 * tab-separated line of kind, name and content. A message is its type chain and its bytes in
 * Base64.
 */
public final class HandOverText {
  private static final String FIRST_WORDS = "U2SA progress 1";
  private static final String LAST_WORDS = "end";
  private static final int KIND = 0;
  private static final int NAME = 1;
  private static final int FIRST = 2;

  private HandOverText() {}

  public static List<String> lines(HandOver state, String systemId) {
    List<String> lines = new ArrayList<>();
    lines.add(String.join("\t", FIRST_WORDS, systemId, state.className()));
    state.values().forEach((name, value) -> lines.add(line(name, value)));
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
    RegularFile.refusePipe(file);
    List<String> lines = Files.readAllLines(file, UTF_8);
    String[] first = lines.isEmpty() ? new String[0] : lines.get(0).split("\t", -1);
    int last = lines.size() - 1;
    while (last > 0 && lines.get(last).isEmpty()) { // room kept for a full disk
      last--;
    }
    if (first.length != 3 || !first[0].equals(FIRST_WORDS) || !lines.get(last).equals(LAST_WORDS)) {
      throw new IOException(file + ": incomplete, or not the progress of a service");
    }
    if (!first[1].equals(systemId)) {
      throw new IOException(
          file + ", line 1: belongs to system \"" + first[1] + "\", expected \"" + systemId + "\"");
    }
    HandOver state = new HandOver(first[2]);
    for (int i = 1; i < last; i++) {
      try {
        readInto(state, lines.get(i), codec);
      } catch (MalformedMessageException | IllegalArgumentException e) {
        throw new IOException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
      }
    }
    return state;
  }

  private static String line(String name, Object value) {
    List<?> values = value instanceof List<?> list ? list : List.of(value);
    List<String> words = new ArrayList<>(List.of(kindOf(value), escaped(name)));
    for (Object each : values) {
      words.add(each instanceof U2SAData message ? bytes(message) : escaped(String.valueOf(each)));
    }
    return String.join("\t", words);
  }

  private static String kindOf(Object value) {
    if (value instanceof List<?> list) { // an empty list fits either kind
      return !list.isEmpty() && list.get(0) instanceof U2SAData ? "messages" : "texts";
    }
    if (value instanceof U2SAData) {
      return "message";
    }
    return value instanceof Boolean ? "flag" : value instanceof Double ? "number" : "text";
  }

  private static String bytes(U2SAData message) {
    return String.join("/", message.typeChain())
        + ":"
        + Base64.getEncoder().encodeToString(message.serialize());
  }

  /**
   * @throws IllegalArgumentException if the line is not in the format of {@link #line}
   */
  private static void readInto(HandOver state, String line, MessageCodec codec)
      throws MalformedMessageException {
    String[] words = line.split("\t", -1);
    if (words.length < FIRST) {
      throw new IllegalArgumentException("\"" + line + "\": expected kind, name and value");
    }
    String name = unescaped(words[NAME]);
    List<String> values = Arrays.asList(words).subList(FIRST, words.length);
    switch (words[KIND]) {
      case "text" -> state.text(name, unescaped(only(values)));
      case "number" -> state.number(name, Double.parseDouble(only(values)));
      case "flag" -> state.flag(name, Boolean.parseBoolean(only(values)));
      case "message" -> state.message(name, message(only(values), codec));
      case "texts" -> {
        List<String> texts = new ArrayList<>();
        values.forEach(each -> texts.add(unescaped(each)));
        state.texts(name, texts);
      }
      case "messages" -> {
        List<U2SAData> messages = new ArrayList<>();
        for (String each : values) {
          messages.add(message(each, codec));
        }
        state.messages(name, messages);
      }
      default ->
          throw new IllegalArgumentException(
              "a value of kind \"" + words[KIND] + "\" is not known");
    }
  }

  private static String only(List<String> values) {
    if (values.size() != 1) {
      throw new IllegalArgumentException(values.size() + " values, expected one");
    }
    return values.get(0);
  }

  private static U2SAData message(String text, MessageCodec codec)
      throws MalformedMessageException {
    int colon = text.indexOf(':');
    List<String> chain = Arrays.asList(text.substring(0, Math.max(0, colon)).split("/"));
    U2SAData message = codec.decode(chain, Base64.getDecoder().decode(text.substring(colon + 1)));
    message.freeze();
    return message;
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\\\")
        .replace("\t", "\\t")
        .replace("\n", "\\n")
        .replace("\r", "\\r");
  }

  private static String unescaped(String text) {
    StringBuilder plain = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c != '\\' || i + 1 == text.length()) {
        plain.append(c);
        continue;
      }
      char code = text.charAt(++i);
      plain.append(code == 't' ? '\t' : code == 'n' ? '\n' : code == 'r' ? '\r' : code);
    }
    return plain.toString();
  }
}
