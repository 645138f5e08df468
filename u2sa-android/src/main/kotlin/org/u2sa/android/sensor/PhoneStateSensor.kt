package org.u2sa.android.sensor

import org.u2sa.messages.frame.MagneticModel
import org.u2sa.device.port.GpsFix
import org.u2sa.device.pressure.PressureAltitude
import org.u2sa.interfaces.time.Clock
import org.u2sa.interfaces.log.LogLevelEnum
import org.u2sa.interfaces.configuration.Description
import org.u2sa.interfaces.configuration.Variable
import org.u2sa.interfaces.communication.Channels
import org.u2sa.messages.StateInformation
import org.u2sa.messages.frame.Point
import org.u2sa.messages.frame.ReferenceFrame
import org.u2sa.service.ProprioceptiveSensor
import org.u2sa.service.ServiceContext

private const val STEPS_PER_S = 20.0
private const val GRAVITY_MPS2 = 9.80665
private const val MICROS_PER_YEAR = 365.2425 * 86_400.0e6
private const val EPOCH_YEAR = 1970.0
private const val WEATHER_M = 100.0 // sea-level pressure varies by about 12 hPa (1 sigma)

private class PhoneTuning(
    @Variable(name = "MOUNTING", ifAbsentText = "FLAT")
    @Description("How the phone is mounted: FLAT on its back, top edge forward; UPRIGHT or SIDEWAYS with its camera forward.")
    val mounting: Mounting,
    @Variable(name = "FIX TIMEOUT", unit = "s", min = 0.1, max = 60.0, ifAbsent = 2.5)
    @Description("Age at which a GPS fix counts as lost: it is not published, and the loss is logged.")
    val fixTimeout: Double,
    @Variable(name = "ATTITUDE TIMEOUT", unit = "s", min = 0.1, max = 60.0, ifAbsent = 0.5)
    @Description("Age at which the phone's attitude counts as lost: it is not published, and the loss is logged.")
    val attitudeTimeout: Double,
    @Variable(name = "HEADING SIGMA", unit = "rad", min = 0.0, minExcluded = true, ifAbsent = 0.17)
    @Description("Standard deviation of the heading if the phone reports none.")
    val headingSigma: Double,
)

/**
 * Publishes the phone's own sensors as two messages, each once per measurement and with its measurement time: "… GPS" with the
 * position, "… attitude" with attitude and turn rate. Out: sensed-state. Thesis 4.6.3: the phone's sensors, before a GPS and a
 * compass were connected to the IOIO.
 *
 * Attitude needs a first fix, because the declination depends on position. The State Estimator fuses the two and drops outdated
 * fixes.
 */
class PhoneStateSensor(context: ServiceContext, private val sensors: PhoneSensors) :
    ProprioceptiveSensor(context, "PhoneSensor", STEPS_PER_S) {
    private val tuning = settings(PhoneTuning::class.java).get()
    private val fixTimeoutMicros = Clock.micros(tuning.fixTimeout)
    private val attitudeTimeoutMicros = Clock.micros(tuning.attitudeTimeout)
    private val gpsName = sensorName() + " GPS"
    private val attitudeName = sensorName() + " attitude"
    private var said = ""
    private var refused = 0L // measurements that no message accepts
    private var lastFix: GpsFix? = null // last published
    private var lastOrientation: PhoneOrientation? = null // last published

    override fun step(nowS: Double) {
        val reading = sensors.read()
        val now = clock().micros()
        report(trouble(reading, now))
        reading.fix
            ?.takeIf { it.valid() && now - it.measuredAtMicros() <= fixTimeoutMicros }
            ?.takeIf { it.measuredAtMicros() != lastFix?.measuredAtMicros() }
            ?.let {
                lastFix = it
                publishing { place(it, reading) }
            }
        val here = lastFix ?: return
        reading.orientation
            ?.takeIf { now - it.measuredAtMicros <= attitudeTimeoutMicros }
            ?.takeIf { it.measuredAtMicros != lastOrientation?.measuredAtMicros }
            ?.let {
                lastOrientation = it
                publishing { attitude(it, here, reading) }
            }
    }

    /** Drops a measurement that its message rejects, such as NaN from a sensor's driver. */
    private fun publishing(state: () -> StateInformation) {
        val measured = try {
            state()
        } catch (e: IllegalArgumentException) {
            refused++
            if (refused.countOneBits() == 1) { // 1, 2, 4, 8…: limits the log
                trouble("the phone's sensors sent invalid data ($refused times so far), last: ${e.message}")
            }
            return
        }
        publish(Channels.SENSED_STATE, measured)
    }

    private fun trouble(reading: PhoneSensors.Reading, now: Long): String = when {
        reading.trouble.isNotEmpty() -> reading.trouble
        reading.fix == null -> "no GPS fix yet"
        !reading.fix.valid() -> "GPS has no position"
        now - reading.fix.measuredAtMicros() > fixTimeoutMicros -> "GPS fix is too old"
        reading.orientation == null || now - reading.orientation.measuredAtMicros > attitudeTimeoutMicros -> "no attitude"
        else -> ""
    }

    private fun report(trouble: String) {
        if (trouble != said) {
            said = trouble
            log(if (trouble.isEmpty()) LogLevelEnum.INFO else LogLevelEnum.WARN, trouble.ifEmpty { "all sensors work" })
        }
    }

    private fun place(fix: GpsFix, reading: PhoneSensors.Reading): StateInformation {
        val state = fix.toState().sensorName(gpsName)
        if (!fix.altitudeM().isPresent) {
            reading.pressure?.let { state.z(PressureAltitude.altitudeM(it.pascals, PressureAltitude.SEA_LEVEL_PA)).zSigma(WEATHER_M) }
        }
        return state
    }

    private fun attitude(orientation: PhoneOrientation, here: GpsFix, reading: PhoneSensors.Reading): StateInformation {
        val at = orientation.measuredAtMicros
        val declinationRad = MagneticModel.declinationRad(here.latitudeDeg(), here.longitudeDeg(), 0.0, year(at))
        val state = StateInformation().sensorName(attitudeName).referenceFrame(ReferenceFrame.GLOBAL)
        state.timestamp(at)
        val attitude = orientation.attitude(tuning.mounting)
        state.phi(attitude.phi).theta(attitude.theta).psi((attitude.psi + declinationRad).mod(2.0 * Math.PI))
        state.psiSigma(orientation.headingSigmaRad ?: tuning.headingSigma)
        movement(orientation, reading, declinationRad, state)
        return state
    }

    private fun movement(
        orientation: PhoneOrientation,
        reading: PhoneSensors.Reading,
        declinationRad: Double,
        state: StateInformation,
    ) {
        reading.acceleration?.let {
            val magnetic = orientation.toEnu(it.vector)
            val trueEnu = turned(magnetic, declinationRad)
            // at rest an accelerometer measures +1 g upward
            state.xDoubleDot(trueEnu.x()).yDoubleDot(trueEnu.y()).zDoubleDot(trueEnu.z() - GRAVITY_MPS2)
        }
        reading.turnRate?.let { state.psiDot(-orientation.toEnu(it.vector).z()) } // psi is clockwise seen from above
    }

    /** Rotates a vector from magnetic to true east and north. */
    private fun turned(magnetic: Point, declinationRad: Double): Point {
        val sin = Math.sin(declinationRad)
        val cos = Math.cos(declinationRad)
        return Point.of(
            cos * magnetic.x() + sin * magnetic.y(),
            -sin * magnetic.x() + cos * magnetic.y(),
            magnetic.z(),
        )
    }

    override fun release() = sensors.close()

    companion object {
        private fun year(micros: Long) = EPOCH_YEAR + micros / MICROS_PER_YEAR
    }
}
