package org.u2sa.cli.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.record.RecordingParts;
import org.u2sa.cli.record.SpanOptions;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.report.mosaic.MosaicFile;
import org.u2sa.report.mosaic.RecordedMosaic;
import org.u2sa.report.mosaic.SurveyMosaic;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa mosaic}: joins the images of a survey into one picture. */
@Command(
    name = "mosaic",
    description = {
      "Join the images of a recorded survey into one map-projected picture.",
      "",
      "  ./u2sa mosaic recording.mcap --resolution 0.1 --out area.tif",
      "",
      "Each pixel comes from the image with the finest ground resolution there. PNG comes with a world file (.pgw) and the "
          + "coordinate reference system (.prj), WGS 84 / UTM. The images are those of a SurveyCamera with IMAGE EVERY above 0."
    })
public final class MosaicCommand extends BaseCommand {
  @Mixin private SpanOptions part;

  @Parameters(paramLabel = "FILE", description = "The recording (MCAP).")
  private Path file;

  @Option(
      names = "--resolution",
      paramLabel = "M",
      defaultValue = "0.1",
      description = "Side of a pixel on the ground [m]. Default: ${DEFAULT-VALUE}.")
  private double pixelM;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE",
      description =
          "Output file, .png or .tif. Default: beside the recording, with its name, as PNG.")
  private Path out;

  @Override
  public Integer call() throws IOException {
    Path target = out;
    if (target == null) {
      String name = file.getFileName().toString().replaceFirst("\\.mcap$", "");
      target = file.resolveSibling(name + "-mosaic.png");
    }
    MosaicFile.requireKind(target);
    try (RecordedMessages recording = RecordedMessages.open(file).requireMessages()) {
      SurveyMosaic mosaic = RecordedMosaic.of(file, recording, part.of(recording.reader()), pixelM);
      MosaicFile.write(mosaic, target);
      print(
          String.format(
              Locale.ROOT,
              "%s (%d by %d pixels, %d images%s, %.2f ha)",
              target,
              mosaic.grid().columns(),
              mosaic.grid().rows(),
              mosaic.used(),
              mosaic.refused() == 0 ? "" : ", " + mosaic.refused() + " refused",
              mosaic.areaM2() / 10_000.0));
      recording.undecodable().ifPresent(what -> tell(what));
    }
    RecordingParts.othersNotRead(file).ifPresent(this::tell);
    return ExitCode.DONE;
  }
}
