package org.u2sa.report.message;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;

/**
 * Parses JSON into maps, lists, texts, Long, Double and Boolean; null becomes an empty Optional.
 * The text cannot instantiate other classes.
 */
public final class JsonReader {
  private static final int DEEPEST = 32;
  private static final JsonFactory FACTORY =
      JsonFactory.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();

  private static final int LONGEST_SHOWN = 300; // characters of others, in errors

  private final JsonParser parser;
  private final String origin;
  private int left; // remaining number of values

  private JsonReader(JsonParser parser, String origin, int most) {
    this.parser = parser;
    this.origin = origin;
    left = most;
  }

  /**
   * Parses one object from a file or another trusted source.
   *
   * @param origin description of the text, for errors
   * @throws BadInputException if it is not JSON, not an object, contains duplicate keys or is
   *     nested too deeply
   */
  public static Map<String, Object> object(String origin, String text) {
    return object(origin, text, Integer.MAX_VALUE);
  }

  /**
   * Parses one object from a network client. Memory depends on values, not characters: an empty
   * object has two characters but takes fifty bytes.
   *
   * @param most maximum number of values, including objects and lists
   * @throws BadInputException as {@link #object(String, String)}, or if there are more values
   */
  public static Map<String, Object> object(String origin, String text, int most) {
    try (JsonParser parser = FACTORY.createParser(text)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new BadInputException(
            origin
                + ": expected a JSON object, such as {\"x\": 1.5}, not \""
                + shortened(text)
                + "\"");
      }
      Map<String, Object> object = new JsonReader(parser, origin, most).map(1);
      if (parser.nextToken() != null) {
        throw new BadInputException(origin + ": unexpected text after the object");
      }
      return object;
    } catch (JsonProcessingException e) {
      JsonLocation at = e.getLocation(); // null if a limit of the parser was exceeded
      String where =
          at == null
              ? origin
              : String.format("%s, line %d, column %d", origin, at.getLineNr(), at.getColumnNr());
      throw new BadInputException(where + ": " + shortened(e.getOriginalMessage()), e);
    } catch (IOException e) {
      throw new UncheckedIOException("reading from memory", e);
    }
  }

  private static String shortened(String text) {
    return text.length() <= LONGEST_SHOWN ? text : text.substring(0, LONGEST_SHOWN) + "…";
  }

  private Map<String, Object> map(int depth) throws IOException {
    Map<String, Object> map = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String key = parser.currentName();
      parser.nextToken();
      map.put(key, value(depth));
    }
    return map;
  }

  private List<Object> list(int depth) throws IOException {
    List<Object> list = new ArrayList<>();
    while (parser.nextToken() != JsonToken.END_ARRAY) {
      list.add(value(depth));
    }
    return list;
  }

  private Object value(int depth) throws IOException {
    if (depth > DEEPEST) {
      throw new BadInputException(origin + ": nested more than " + DEEPEST + " deep");
    }
    if (--left < 0) {
      throw new BadInputException(origin + ": has too many values");
    }
    return switch (parser.currentToken()) {
      case START_OBJECT -> map(depth + 1);
      case START_ARRAY -> list(depth + 1);
      case VALUE_STRING -> parser.getText();
      case VALUE_NUMBER_INT -> parser.getLongValue();
      case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
      case VALUE_TRUE -> Boolean.TRUE;
      case VALUE_FALSE -> Boolean.FALSE;
      default -> Optional.empty();
    };
  }
}
