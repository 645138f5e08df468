package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.Size;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.registry.StandardTypes;

/** What must hold for every registered message with any values, and for any bytes. */
class CodecProperties {
  private static MessageCodec codec(WireForm keys) {
    return new MessageCodec(StandardTypes.registry(), keys);
  }

  @Provide
  Arbitrary<U2SAData> messages() {
    return MessageArbitraries.anyMessage();
  }

  @Property(seed = "2014")
  void decode_whatWasEncoded_isEqualAndGivesTheSameBytes(
      @ForAll("messages") U2SAData message, @ForAll WireForm keys)
      throws MalformedMessageException {
    MessageCodec codec = codec(keys);
    byte[] bytes = codec.encode(message);

    U2SAData read = codec.decode(message.typeChain(), bytes);

    assertThat(read).isEqualTo(message).hasSameHashCodeAs(message);
    assertThat(read.getClass()).isEqualTo(message.getClass());
    assertThat(read.presenceVector()).isEqualTo(message.presenceVector());
    assertThat(codec.encode(read)).isEqualTo(bytes);
    assertThat(read.serialize()).isEqualTo(message.serialize());
    assertThat(message.copy()).isEqualTo(message);
  }

  @Property(tries = 200, seed = "2014")
  void decode_bytesFlipped_messageOrOneException(
      @ForAll("messages") U2SAData message, @ForAll WireForm keys, @ForAll Random random) {
    byte[] bytes = codec(keys).encode(message);
    for (int flips = 1 + random.nextInt(4); flips > 0; flips--) {
      bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
    }
    decodes(message.typeChain(), bytes);
  }

  @Property(tries = 200, seed = "2014")
  void decode_bytesCut_oneException(@ForAll("messages") U2SAData message, @ForAll WireForm keys) {
    byte[] bytes = codec(keys).encode(message);
    for (int length = 0; length < bytes.length; length += 1 + bytes.length / 300) {
      assertThat(decodes(message.typeChain(), Arrays.copyOf(bytes, length)))
          .as("%d of %d bytes", length, bytes.length)
          .isFalse();
    }
  }

  @Property(seed = "2014")
  void decode_anyBytes_messageOrOneException(
      @ForAll @Size(max = 64) byte[] bytes, @ForAll Random random) {
    List<MessageType<?>> types = MessageArbitraries.concreteTypes();
    decodes(types.get(random.nextInt(types.size())).chain(), bytes);
  }

  /** False if refused as it should be; any other exception fails the test. */
  private boolean decodes(List<String> chain, byte[] bytes) {
    try {
      assertThat(codec(WireForm.READABLE).decode(chain, bytes)).isNotNull();
      return true;
    } catch (MalformedMessageException e) {
      assertThat(e.getMessage()).isNotBlank();
      assertThat(e.offset()).isBetween(0L, (long) bytes.length);
      return false;
    }
  }
}
