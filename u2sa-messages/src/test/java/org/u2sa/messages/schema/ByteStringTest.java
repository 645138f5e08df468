package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.nio.ReadOnlyBufferException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.registry.StandardTypes;

/** Bytes in messages: kept unchanged, written, read, refused. */
class ByteStringTest {
  /** {"sensorName": "C", "format": "p", "data": …}, the value left out. */
  private static final String BEFORE_DATA =
      "a36a73656e736f724e616d65614366666f726d617461706464617461";

  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  private static CameraImage image(byte... bytes) {
    return new CameraImage().sensorName("C").format("p").data(ByteString.copyOf(bytes));
  }

  private CameraImage decode(String hexOfData) throws MalformedMessageException {
    byte[] bytes = HexFormat.of().parseHex((BEFORE_DATA + hexOfData).replace(" ", ""));
    return (CameraImage) codec.decode(CameraImage.TYPE.chain(), bytes);
  }

  @Test
  void copyOf_arrayChangedAfterwards_staysAsItWas() {
    byte[] bytes = {1, 2};
    ByteString kept = ByteString.copyOf(bytes);
    bytes[0] = 9;
    kept.toBytes()[1] = 9;

    assertThat(kept.toBytes()).containsExactly(1, 2);
    assertThatThrownBy(() -> kept.view().put((byte) 9)).isInstanceOf(ReadOnlyBufferException.class);
  }

  @Test
  void view_readTwice_beginsAnew() {
    ByteString kept = ByteString.copyOf(new byte[] {1, 2});
    ByteBuffer first = kept.view();
    first.get();

    assertThat(kept.view().remaining()).isEqualTo(2);
    assertThat(first.remaining()).isEqualTo(1);
  }

  @Test
  void equals_sameBytes_isTrueOfThemAndOfTheirMessages() {
    ByteString one = ByteString.copyOf(new byte[] {1, 2});

    assertThat(one).isEqualTo(ByteString.copyOf(new byte[] {1, 2}));
    assertThat(one).hasSameHashCodeAs(ByteString.copyOf(new byte[] {1, 2}));
    assertThat(one).isNotEqualTo(ByteString.copyOf(new byte[] {1, 3}));
    assertThat(image((byte) 1)).isEqualTo(image((byte) 1)).isNotEqualTo(image((byte) 2));
  }

  @Test
  void toString_ofAMessage_hasTheLengthNotTheBytes() {
    assertThat(image((byte) 1, (byte) 2))
        .hasToString("CameraImage{sensorName=C, format=p, width=0 px, height=0 px, data=2 bytes}");
    assertThat(ByteString.copyOf(new byte[1])).hasToString("1 byte");
  }

  @Test
  void setText_base64_isTheBytes() {
    CameraImage image = image();
    CameraImage.TYPE.field("data").orElseThrow().setText(image, " /9gB\n  Ag== ");

    assertThat(image.data().toBytes()).containsExactly(0xff, 0xd8, 1, 2);
    assertThat(image.data().toBase64()).isEqualTo("/9gBAg==");
    assertThatThrownBy(() -> CameraImage.TYPE.field("data").orElseThrow().setText(image, "a?b"))
        .hasMessage("CameraImage.data: expected bytes in base64, not \"a?b\"");
  }

  @Test
  void set_whatIsNoByteString_isRefused() {
    MessageField<CameraImage> data = CameraImage.TYPE.field("data").orElseThrow();

    assertThatThrownBy(() -> data.set(image(), "text"))
        .hasMessage("CameraImage.data: expected bytes, not \"text\"");
    assertThatThrownBy(() -> data.set(image(), null)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> image(new byte[Limits.BYTE_STRING_BYTES + 1]))
        .hasMessageContaining("CameraImage.data: expected at most 983040 bytes");
  }

  @Test
  void decode_theMostBytes_areReadAsWritten() throws MalformedMessageException {
    CameraImage most = image(new byte[Limits.BYTE_STRING_BYTES]);

    assertThat(codec.decode(most.typeChain(), most.serialize())).isEqualTo(most);
  }

  @Test
  void decode_byteStringInPieces_isOne() throws MalformedMessageException {
    assertThat(decode("5f 42 0102 40 41 ff ff").data().toBytes()).containsExactly(1, 2, 0xff);
    assertThat(decode("5f ff").data().length()).isZero();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "6101 | CameraImage.data, byte 29: expected a byte string, not text",
        "f6 | expected a byte string, not null",
        "8101 | expected a byte string, not an array",
        "42 01 | expected more bytes, not the end",
        "5a 000f0001 | expected at most 983040 bytes in a byte string",
        "5a ffffffff | expected at most 983040 bytes in a byte string",
        "5b ffffffffffffffff | expected at most 983040 bytes in a byte string",
        "5c | expected a length or a value, not a reserved CBOR code",
        "5f 41 01 | expected a data item or a break, not the end",
        "5f 61 61 ff | expected a piece of a byte string or its end, not text",
        "5f 5f 41 01 ff ff | expected a piece of a byte string or its end, not a byte string",
        "5f 41 01 5a 000f0000 | expected at most 983040 bytes in a byte string"
      })
  void decode_brokenByteString_saysWhereAndWhatWasExpected(String hex, String expected) {
    assertThatThrownBy(() -> decode(hex))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("CameraImage.data")
        .hasMessageContaining(expected);
  }

  @Test
  void decode_withoutData_isRefused() {
    assertThatThrownBy(
            () ->
                codec.decode(
                    CameraImage.TYPE.chain(),
                    HexFormat.of().parseHex("a26a73656e736f724e616d65614366666f726d61746170")))
        .hasMessageContaining("CameraImage.data is required and missing");
  }

  /** {"q": h'0102'} and {"q": [h'01']}. */
  @Test
  void decode_byteStringOfAnUnknownType_isKeptAndWrittenAgain() throws MalformedMessageException {
    byte[] bytes = HexFormat.of().parseHex("a16171420102");
    U2SAData read = codec.decode(List.of("NobodyKnows"), bytes);

    assertThat(read.unknownFields()).isEqualTo(Map.of("q", ByteString.copyOf(new byte[] {1, 2})));
    assertThat(read.serialize()).isEqualTo(bytes);
    byte[] nested = HexFormat.of().parseHex("a16171814101");
    assertThat(codec.decode(List.of("NobodyKnows"), nested).serialize()).isEqualTo(nested);
  }

  @Test
  void size_lessThanOnePixel_isRefused() {
    assertThatThrownBy(() -> image().size(640, 0))
        .hasMessage("CameraImage: expected a size of at least 1 x 1 px, not 640 x 0");
    assertThat(image().size(640, 480).width()).isEqualTo(640);
  }
}
