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

  private JsonReader() {}

  /**
   * Parses one object.
   *
   * @param origin description of the text, for errors
   * @throws BadInputException if it is not JSON, not an object, contains duplicate keys or is
   *     nested too deeply
   */
  public static Map<String, Object> object(String origin, String text) {
    try (JsonParser parser = FACTORY.createParser(text)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new BadInputException(
            origin + ": expected an object of JSON, such as {\"x\": 1.5}, not \"" + text + "\"");
      }
      Map<String, Object> object = map(parser, origin, 1);
      if (parser.nextToken() != null) {
        throw new BadInputException(origin + ": unexpected text after the object");
      }
      return object;
    } catch (JsonProcessingException e) {
      JsonLocation at = e.getLocation(); // null where a limit of the parser is exceeded
      String where =
          at == null
              ? origin
              : String.format("%s, line %d, column %d", origin, at.getLineNr(), at.getColumnNr());
      throw new BadInputException(where + ": " + e.getOriginalMessage(), e);
    } catch (IOException e) {
      throw new UncheckedIOException("reading from memory", e);
    }
  }

  private static Map<String, Object> map(JsonParser parser, String origin, int depth)
      throws IOException {
    Map<String, Object> map = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String key = parser.currentName();
      parser.nextToken();
      map.put(key, value(parser, origin, depth));
    }
    return map;
  }

  private static List<Object> list(JsonParser parser, String origin, int depth) throws IOException {
    List<Object> list = new ArrayList<>();
    while (parser.nextToken() != JsonToken.END_ARRAY) {
      list.add(value(parser, origin, depth));
    }
    return list;
  }

  private static Object value(JsonParser parser, String origin, int depth) throws IOException {
    if (depth > DEEPEST) {
      throw new BadInputException(origin + ": nested more than " + DEEPEST + " deep");
    }
    return switch (parser.currentToken()) {
      case START_OBJECT -> map(parser, origin, depth + 1);
      case START_ARRAY -> list(parser, origin, depth + 1);
      case VALUE_STRING -> parser.getText();
      case VALUE_NUMBER_INT -> parser.getLongValue();
      case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
      case VALUE_TRUE -> Boolean.TRUE;
      case VALUE_FALSE -> Boolean.FALSE;
      default -> Optional.empty();
    };
  }
}
