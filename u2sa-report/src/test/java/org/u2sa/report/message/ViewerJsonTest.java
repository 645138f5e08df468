package org.u2sa.report.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.recorder.SchemaText;

class ViewerJsonTest {
  /** What Lichtblick's parseJsonSchema takes as a property, and as an element of a list. */
  private static final Set<String> SIMPLE =
      Set.of("boolean", "string", "number", "integer", "object");

  static Stream<MessageType<?>> types() {
    return MessageTypes.discovered().all().stream();
  }

  @ParameterizedTest
  @MethodSource("types")
  void schema_anyMessage_isWithinWhatViewersRead(MessageType<?> type) throws IOException {
    JsonNode schema =
        new ObjectMapper().readTree(ViewerJson.schema(type.name(), SchemaText.of(type)));
    assertThat(schema.get("type").asText()).isEqualTo("object");
    requireReadable(schema.get("properties"));
  }

  private static void requireReadable(JsonNode properties) {
    for (JsonNode property : properties) {
      boolean isList = property.get("type").asText().equals("array");
      JsonNode simple = isList ? property.get("items") : property;
      assertThat(SIMPLE).as("%s", property).contains(simple.get("type").asText());
      if (simple.has("properties")) {
        requireReadable(simple.get("properties"));
      }
    }
  }

  @Test
  void fields_listOfPoints_isOfObjects() {
    PlannedPath path = new PlannedPath().points(List.of(new Point(1.0, 2.0, 3.0)));
    assertThat(ViewerJson.fields(path).line()).contains("[{\"x\":1.0,\"y\":2.0,\"z\":3.0}]");
  }

  @Test
  void schema_noJson_saysWhose() {
    assertThatThrownBy(() -> ViewerJson.schema("Depth", "[1]"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("Depth");
  }
}
