package org.u2sa.scenarios.suas;

import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.report.mosaic.MosaicFile;
import org.u2sa.report.mosaic.MosaicGrid;
import org.u2sa.report.mosaic.SurveyMosaic;

/** The mosaic of a field's search area: assembled in flight, written and scored at the end. */
final class FieldMosaic {
  private static final double MARGIN_M = 10.0;
  private static final double IMAGE_EVERY_S = 1.0;

  private final SuasField field;
  private final FieldGround ground;
  private final SurveyMosaic mosaic;
  private final Path file;

  FieldMosaic(SuasField field, double pixelM, Path file) {
    this.field = field;
    this.file = file;
    ground = new FieldGround(field.searchArea(), field.targets(), field.ground(), field.seed());
    mosaic =
        new SurveyMosaic(
            MosaicGrid.around(
                field.searchArea().stream()
                    .map(corner -> SuasField.plane().at(corner.x(), corner.y(), 0.0))
                    .collect(Collectors.toList()),
                pixelM,
                MARGIN_M));
  }

  FieldGround ground() {
    return ground;
  }

  /** Has the camera publish its images, and starts the mosaic's service. */
  void start(LaunchOptions launch) {
    launch.override("SurveyCamera", "IMAGE EVERY", IMAGE_EVERY_S);
    launch.beside(
        XmlConfiguration.inMemory("MosaicStation", Map.of()),
        context -> new MosaicStation(context, mosaic));
  }

  /** Writes the mosaic; returns its metrics, by ground truth. */
  Map<String, Double> figures() {
    MosaicFile.write(mosaic, file);
    return MosaicScore.of(mosaic, field.searchArea(), field.targets(), ground);
  }
}
