package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Numbers whose names end within each of the words that they are written by, and beyond them. */
class NumberKeysTest {
  /** A message with a number of each length of name from 1 to 40. */
  private static final class Named extends U2SAData {
    private static final Schema<Named> SCHEMA = Schema.of(Named.class, Named::new, U2SAData.TYPE);

    static {
      for (int length = 1; length <= 40; length++) {
        SCHEMA.optionalNumber("n".repeat(length), "m");
      }
    }

    private static final MessageType<Named> TYPE = SCHEMA.build();

    @Override
    public MessageType<Named> type() {
      return TYPE;
    }
  }

  private static Named withNumbers(int from, int step) {
    Named message = new Named();
    for (int length = from; length <= 40; length += step) {
      Named.TYPE.field("n".repeat(length)).orElseThrow().set(message, length + 0.5);
    }
    return message;
  }

  @Test
  void serialize_namesOfAnyLength_areWholeAndReadAgain() throws MalformedMessageException {
    MessageCodec codec = new MessageCodec(MessageTypes.of(List.of(Named.TYPE)));
    for (int step = 1; step <= 40; step++) {
      for (int from = 1; from <= step; from++) {
        Named message = withNumbers(from, step);
        byte[] bytes = message.serialize();

        assertThat(new String(bytes, StandardCharsets.ISO_8859_1)).contains("n".repeat(from));
        assertThat(codec.decode(Named.TYPE.chain(), bytes)).isEqualTo(message);
        CborInput in = new CborInput(bytes);
        in.skip(Limits.DEPTH);
        assertThat(in.isAtEnd()).isTrue();
      }
    }
  }
}
