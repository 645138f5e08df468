package org.u2sa.report.summary;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * Writes JSON with numbers rounded to thousandths. A missing number is {@code null} with a reason
 * in {@code absent}, since JSON has no NaN.
 */
final class SummaryNumbers implements Closeable {

  private static final int DECIMALS = 3;

  private final Writer out;
  private final JsonGenerator json;
  private final Map<String, String> absent = new LinkedHashMap<>();

  SummaryNumbers(Writer out) throws IOException {
    this.out = out;
    json = new JsonFactory().createGenerator(out);
    json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET);
    json.setPrettyPrinter(
        new DefaultPrettyPrinter().withObjectIndenter(new DefaultIndenter("  ", "\n")));
  }

  JsonGenerator generator() {
    return json;
  }

  /** Writes a number of a part of the summary, named {@code of} in the reasons. */
  void number(String key, OptionalDouble value, String reasonIfAbsent, String of)
      throws IOException {
    if (value.isPresent()) {
      number(key, value.getAsDouble());
    } else {
      absent.put(of.isEmpty() ? key : of + ": " + key, reasonIfAbsent);
      json.writeNullField(key);
    }
  }

  void number(String key, OptionalDouble value, String reasonIfAbsent) throws IOException {
    number(key, value, reasonIfAbsent, "");
  }

  void number(String key, double value) throws IOException {
    json.writeFieldName(key);
    json.writeNumber(BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN));
  }

  /** Writes the reasons for all numbers missing so far. */
  void absences() throws IOException {
    json.writeObjectFieldStart("absent");
    for (Map.Entry<String, String> entry : absent.entrySet()) {
      json.writeStringField(entry.getKey(), entry.getValue());
    }
    json.writeEndObject();
  }

  /** Ends the document with a line feed; does not close the writer. */
  @Override
  public void close() throws IOException {
    json.close();
    out.write('\n');
    out.flush();
  }
}
