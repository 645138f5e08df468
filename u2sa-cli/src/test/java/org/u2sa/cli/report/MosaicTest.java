package org.u2sa.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/** A recording with one image of 11 m by 7 m. */
class MosaicTest extends CommandFixture {
  @TempDir private Path folder;

  private Path recording(boolean withImage) throws IOException {
    Path file = folder.resolve("run.mcap");
    Point corner = Point.of(8.0, 50.0, 0.0);
    Point north = Point.of(0.0, 1e-4, 0.0);
    Point east = Point.of(1e-4, 0.0, 0.0);
    ImageFootprint footprint = new ImageFootprint().resolution(0.1);
    footprint.points(
        List.of(corner.plus(north), corner.plus(north).plus(east), corner.plus(east), corner));
    footprint.uid("image 1").objectType("image");
    footprint.sensorName("camera").x(8.0).y(50.0).referenceFrame(ReferenceFrame.GLOBAL);
    footprint.timestamp(5);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(new BufferedImage(70, 110, BufferedImage.TYPE_INT_RGB), "jpeg", bytes);
    CameraImage image =
        new CameraImage()
            .sensorName("camera")
            .format(CameraImage.JPEG)
            .data(ByteString.copyOf(bytes.toByteArray()));
    image.timestamp(5);
    try (McapWriter writer =
        new McapWriter(
            Files.newByteChannel(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE),
            McapOptions.usual(ChunkCompression.LZ4, "test"))) {
      write(writer, 0, Channels.SENSED_OBJECTS, footprint);
      if (withImage) {
        write(writer, 1, Channels.IMAGES, image);
      }
    }
    return file;
  }

  private static void write(McapWriter writer, int id, Channel<?> channel, U2SAData message)
      throws IOException {
    String topic = Topic.of("plane", channel, message).toString();
    writer.add(new McapChannel(id, 0, topic, "cbor", Map.of()));
    writer.add(new McapMessage(id, 0, 1_000L + id, 1_000L + id, message.serialize()));
  }

  @Test
  void mosaic_oneImage_isWrittenBesideTheRecording() throws IOException {
    assertThat(u2sa("mosaic", recording(true).toString())).as(err.toString()).isZero();
    assertThat(out.toString()).contains("run-mosaic.png", "1 images");
    assertThat(folder.resolve("run-mosaic.pgw")).exists();
    assertThat(ImageIO.read(folder.resolve("run-mosaic.png").toFile()).getWidth())
        .isBetween(270, 280); // 7.2 m and twice 10 m
  }

  @Test
  void mosaic_noImages_saysHowToGetSome() throws IOException {
    assertThat(u2sa("mosaic", recording(false).toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .contains("expected those of a SurveyCamera with IMAGE EVERY above 0");
  }
}
