package org.u2sa.service;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/**
 * One value of a {@link HandOver} as a line of text: kind, name, and what there is of it, with tabs
 * between. A message is its type chain and its bytes in Base64.
 */
final class ProgressLine {
  private static final int KIND = 0;
  private static final int NAME = 1;
  private static final int FIRST = 2;

  private ProgressLine() {}

  static String of(String name, Object value) {
    List<String> words = new ArrayList<>();
    words.add("");
    words.add(escaped(name));
    if (value instanceof List<?> list) {
      boolean messages = !list.isEmpty() && list.get(0) instanceof U2SAData;
      words.set(KIND, messages ? "messages" : "texts"); // an empty list is of either kind
      list.forEach(each -> words.add(messages ? bytes((U2SAData) each) : escaped((String) each)));
    } else if (value instanceof U2SAData message) {
      words.set(KIND, "message");
      words.add(bytes(message));
    } else {
      words.set(KIND, kindOf(value));
      words.add(escaped(String.valueOf(value)));
    }
    return String.join("\t", words);
  }

  private static String kindOf(Object value) {
    if (value instanceof Boolean) {
      return "flag";
    }
    return value instanceof Double ? "number" : "text";
  }

  private static String bytes(U2SAData message) {
    return String.join("/", message.typeChain())
        + ":"
        + Base64.getEncoder().encodeToString(message.serialize());
  }

  /**
   * @throws IllegalArgumentException if the line is none that {@link #of} writes
   * @throws MalformedMessageException if a message in it is none
   */
  static void readInto(HandOver state, String line, MessageCodec codec)
      throws MalformedMessageException {
    String[] words = line.split("\t", -1);
    if (words.length < FIRST) {
      throw new IllegalArgumentException("\"" + line + "\": expected kind, name and value");
    }
    String name = unescaped(words[NAME]);
    List<String> values = Arrays.asList(words).subList(FIRST, words.length);
    switch (words[KIND]) {
      case "texts":
        List<String> texts = new ArrayList<>();
        values.forEach(each -> texts.add(unescaped(each)));
        state.texts(name, texts);
        break;
      case "messages":
        List<U2SAData> messages = new ArrayList<>();
        for (String each : values) {
          messages.add(message(each, codec));
        }
        state.messages(name, messages);
        break;
      default:
        readOneInto(state, words[KIND], name, only(values), codec);
    }
  }

  private static String only(List<String> values) {
    if (values.size() != 1) {
      throw new IllegalArgumentException(values.size() + " values, expected one");
    }
    return values.get(0);
  }

  private static void readOneInto(
      HandOver state, String kind, String name, String value, MessageCodec codec)
      throws MalformedMessageException {
    switch (kind) {
      case "text":
        state.text(name, unescaped(value));
        break;
      case "number":
        state.number(name, Double.parseDouble(value));
        break;
      case "flag":
        state.flag(name, Boolean.parseBoolean(value));
        break;
      case "message":
        state.message(name, message(value, codec));
        break;
      default:
        throw new IllegalArgumentException("a value of kind \"" + kind + "\" is not known");
    }
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
