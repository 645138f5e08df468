package org.u2sa.trials.campaign;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.TreeMap;

/**
 * The metrics of a {@code summary.json}: its top-level numbers by name, and one aggregate per list:
 * {@code worstMissM} of the waypoints and {@code leastDistanceM} of the obstacles.
 */
final class SummaryFigures {
  private static final JsonFactory FACTORY = new JsonFactory();
  private static final String MISS = "missM";
  private static final String DISTANCE = "leastDistanceM";

  private SummaryFigures() {}

  /** Whether a text is a JSON object, from start to end. */
  static boolean areIn(String text) {
    if (!text.startsWith("{")) {
      return false;
    }
    try (JsonParser json = FACTORY.createParser(text)) {
      while (json.nextToken() != null) {
        // consumes all tokens
      }
      return true;
    } catch (IOException e) {
      return false; // reading a string: only its syntax can be wrong
    }
  }

  /** The metrics of a summary; none for an empty text. */
  static Map<String, Double> of(String summary) {
    Map<String, Double> figures = new TreeMap<>();
    try (JsonParser json = FACTORY.createParser(summary)) {
      int depth = 0;
      for (JsonToken token = json.nextToken(); token != null; token = json.nextToken()) {
        if (token.isStructStart()) {
          depth++;
        } else if (token.isStructEnd()) {
          depth--;
        } else if (token.isNumeric()) {
          take(json.currentName(), json.getDoubleValue(), depth, figures);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException("summary.json of a run: " + e.getMessage(), e);
    }
    figures.remove("seed");
    return figures;
  }

  private static void take(String name, double value, int depth, Map<String, Double> figures) {
    if (depth == 1) {
      figures.put(name, value);
    } else if (MISS.equals(name)) {
      figures.merge("worstMissM", value, Math::max);
    } else if (DISTANCE.equals(name)) {
      figures.merge(DISTANCE, value, Math::min);
    }
  }
}
