package org.u2sa.android.sensor

import org.u2sa.interfaces.log.LogLevelEnum
import org.u2sa.service.ExteroceptiveSensor
import org.u2sa.service.ServiceContext

private const val STEPS_PER_S = 30.0

/**
 * A service that looks through the phone's camera (thesis 4.1.2): its author writes [look]. Out: sensed-objects.
 *
 * A class of a system file with a public constructor (ServiceContext, PhoneCamera) is given the camera by the application;
 * nothing else has to be registered. The camera is opened when the service is made, and closed with it.
 */
abstract class CameraSensor(context: ServiceContext, serviceName: String, private val camera: PhoneCamera) :
    ExteroceptiveSensor(context, serviceName, STEPS_PER_S) {
    private var seen: PhoneCamera.Picture? = null
    private var said = ""

    /** Looks at a picture, each at most once and the newest only, on the service's thread. */
    protected abstract fun look(picture: PhoneCamera.Picture)

    final override fun step(nowS: Double) {
        val trouble = camera.trouble
        if (trouble != said) {
            said = trouble
            if (trouble.isEmpty()) log(LogLevelEnum.INFO, "the camera sees") else trouble(trouble)
        }
        val picture = camera.latest()
        if (picture != null && picture !== seen) {
            seen = picture
            look(picture)
        }
    }

    final override fun release() = camera.close()
}
