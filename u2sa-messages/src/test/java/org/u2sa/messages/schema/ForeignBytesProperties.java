package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.u2sa.messages.cbor.Cbor;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.registry.StandardTypes;

/**
 * Other encoders than ours: pairs in any order, maps without a length, keys whose length takes more
 * bytes than it must, tags. All that is read in a moment when it comes in our order and form must
 * mean the same in any other.
 */
class ForeignBytesProperties {
  private static final int SELF_DESCRIBED = 0xD9; // tag 55799, RFC 8949, 3.4.6
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  /** A key and its value, as they were written. */
  private record Pair(byte[] key, byte[] value) {
    void write(ByteArrayOutputStream out, Random random) {
      boolean isShort = (key[0] & Cbor.INFO) < Cbor.ONE_BYTE;
      if (isShort && random.nextInt(8) == 0) {
        out.write(key[0] & Cbor.MAJOR | Cbor.ONE_BYTE); // length or label in a byte of its own
        out.write(key[0] & Cbor.INFO);
        out.write(key, 1, key.length - 1);
      } else {
        out.writeBytes(key);
      }
      if (random.nextInt(8) == 0) {
        out.write(SELF_DESCRIBED);
        out.write(0xD9);
        out.write(0xF7);
      }
      out.writeBytes(value);
    }
  }

  @Provide
  Arbitrary<U2SAData> messages() {
    return MessageArbitraries.anyMessage();
  }

  private static List<Pair> pairs(byte[] bytes) {
    CborInput in = new CborInput(bytes);
    List<Pair> pairs = new ArrayList<>();
    for (long left = in.map(); left > 0; left--) {
      int start = in.offset();
      in.skip(0);
      int middle = in.offset();
      in.skip(Limits.DEPTH);
      byte[] key = Arrays.copyOfRange(bytes, start, middle);
      pairs.add(new Pair(key, Arrays.copyOfRange(bytes, middle, in.offset())));
    }
    return pairs;
  }

  /** Some with their names, some with their labels. */
  private static List<Pair> inEitherForm(U2SAData message, Random random) {
    List<Pair> pairs = pairs(message.serialize());
    List<Pair> labelled =
        pairs(new MessageCodec(StandardTypes.registry(), WireForm.COMPACT).encode(message));
    for (int i = 0; i < pairs.size(); i++) {
      if (random.nextBoolean()) {
        pairs.set(i, labelled.get(i));
      }
    }
    return pairs;
  }

  private static byte[] bytes(List<Pair> pairs, Random random) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    boolean isEndless = random.nextBoolean();
    if (isEndless) {
      out.write(Cbor.MAP | Cbor.INDEFINITE);
    } else {
      out.write(Cbor.MAP | Cbor.TWO_BYTES);
      out.write(0);
      out.write(pairs.size());
    }
    pairs.forEach(pair -> pair.write(out, random));
    if (isEndless) {
      out.write(Cbor.BREAK);
    }
    return out.toByteArray();
  }

  /** A few pairs change places, or all of them. */
  private static void disorder(List<Pair> pairs, Random random) {
    if (random.nextBoolean()) {
      Collections.shuffle(pairs, random);
    } else if (!pairs.isEmpty()) {
      Collections.swap(pairs, random.nextInt(pairs.size()), random.nextInt(pairs.size()));
    }
  }

  @Property(seed = "2014")
  void decode_inAnyOrderAndForm_isTheSameMessage(
      @ForAll("messages") U2SAData message, @ForAll Random random)
      throws MalformedMessageException {
    List<Pair> pairs = inEitherForm(message, random);
    disorder(pairs, random);

    U2SAData read = codec.decode(message.typeChain(), bytes(pairs, random));

    assertThat(read).isEqualTo(message);
    assertThat(read.serialize()).isEqualTo(message.serialize());
  }

  @Property(seed = "2014")
  void decode_aPairTwice_isRefused(@ForAll("messages") U2SAData message, @ForAll Random random) {
    List<Pair> pairs = inEitherForm(message, random);
    if (pairs.isEmpty()) {
      return;
    }
    int twice = random.nextInt(pairs.size());
    Pair again = inEitherForm(message, random).get(twice);
    pairs.add(random.nextInt(pairs.size() + 1), again);

    assertThatThrownBy(() -> codec.decode(message.typeChain(), bytes(pairs, random)))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("the key occurs twice");
  }
}
