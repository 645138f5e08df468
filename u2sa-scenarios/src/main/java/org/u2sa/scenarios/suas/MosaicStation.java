package org.u2sa.scenarios.suas;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.report.mosaic.SurveyMosaic;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Assembles the mosaic on the ground in flight. In: images, sensed-objects. Out: nothing. */
final class MosaicStation extends PeriodicService {
  private final SurveyMosaic mosaic;

  MosaicStation(ServiceContext context, SurveyMosaic mosaic) {
    super(context, ServiceRole.OBSERVER, "MosaicStation", 1.0);
    this.mosaic = mosaic;
    subscribe(Channels.IMAGES, mosaic::take);
    subscribe(Channels.SENSED_OBJECTS, mosaic::take);
  }

  @Override
  protected void step(double nowS) {
    remark("IMAGES", String.valueOf(mosaic.used()));
  }
}
