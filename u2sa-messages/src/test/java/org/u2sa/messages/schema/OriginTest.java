package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.StopCommand;

class OriginTest {
  private static final Origin ORIGIN = new Origin("1f0c", 17);
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  @Test
  void serialize_withOrigin_isReadBackAndIsNoPartOfTheMessage() throws MalformedMessageException {
    Waypoint waypoint = new Waypoint().uid("1").x(1).y(2).horizontalThreshold(3);

    U2SAData read = codec.decode(waypoint.typeChain(), codec.encode(waypoint, ORIGIN));

    assertThat(read.origin()).contains(ORIGIN);
    assertThat(read).isEqualTo(waypoint);
    assertThat(read.enumerateFields()).isEqualTo(waypoint.enumerateFields());
    assertThat(read.serialize()).isEqualTo(waypoint.serialize());
  }

  @Test
  void serialize_withOrigin_endsWithTheKeptBytes() throws IOException {
    byte[] kept = Files.readAllBytes(Repository.file("docs/wire/origin.cbor"));

    StopCommand stop = new StopCommand().stopAll(true);
    stop.systemId("cessna");
    stop.timestamp(1_700_000_000_123_456L);
    assertThat(codec.encode(stop, ORIGIN)).isEqualTo(kept);
  }

  @Test
  void decode_unknownType_keepsTheOriginOutOfItsFields() throws MalformedMessageException {
    StopCommand stop = new StopCommand().stopAll(true);

    U2SAData read = codec.decode(List.of("Unheard"), codec.encode(stop, ORIGIN));

    assertThat(read.origin()).contains(ORIGIN);
    assertThat(read.unknownFields()).containsOnlyKeys("stopAll");
  }

  @Test
  void decode_originOfAnotherForm_isRefused() {
    byte[] bytes = codec.encode(new StopCommand(), ORIGIN);
    bytes[bytes.length - 1] = 0x00; // sequence 0
    assertThatThrownBy(() -> codec.decode(List.of("StopCommand"), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("sequence: 0 is less than 1");
    bytes[bytes.length - 1] = (byte) 0xf5;
    assertThatThrownBy(() -> codec.decode(List.of("StopCommand"), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("StopCommand.origin");
  }

  @Test
  void new_withoutSender_isRefused() {
    assertThatThrownBy(() -> new Origin("", 1))
        .hasMessage("sender: expected 1…64 characters, not 0");
  }
}
