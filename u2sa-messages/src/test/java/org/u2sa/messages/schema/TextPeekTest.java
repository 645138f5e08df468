package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.registry.StandardTypes;

/** One text of a message that is not decoded. */
class TextPeekTest {
  private static final MessageTypes TYPES = StandardTypes.registry();

  @ParameterizedTest
  @EnumSource(WireForm.class)
  void peek_nameBehindOrAmongOtherFields_isFound(WireForm form) {
    MessageCodec codec = new MessageCodec(TYPES, form);
    StateInformation state = new StateInformation().x(1.0).sensorName("gps");
    state.systemId("cessna");
    state.timestamp(1);

    assertThat(codec.peek(codec.encode(state, new Origin("a", 1)), "sensorName")).contains("gps");
    assertThat(codec.peek(codec.encode(state), "actuatorName")).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "a26178820102646e616d656162, b, name", // behind an array
    "bf646e616d656162ff, b, name", // indefinite
    "a1c1646e616d656162, b, name", // a tag before the key
  })
  void peek_oddForms_areReadAsReadersDo(String hex, String text, String field) {
    byte[] payload = HexFormat.of().parseHex(hex);

    assertThat(new MessageCodec(TYPES).peek(payload, field)).contains(text);
  }

  @Test
  void peek_whatIsNoMessage_isEmpty() {
    MessageCodec codec = new MessageCodec(TYPES);

    assertThat(codec.peek(new byte[0], "name")).isEmpty();
    assertThat(codec.peek(HexFormat.of().parseHex("a1646e616d6501"), "name")).isEmpty();
    assertThat(codec.peek(HexFormat.of().parseHex("a1646e616d65"), "name")).isEmpty();
  }
}
