package org.u2sa.android.sensor

import org.u2sa.device.MagneticModel
import org.u2sa.device.GpsFix
import org.u2sa.interfaces.time.Clock
import org.u2sa.interfaces.log.LogLevelEnum
import org.u2sa.interfaces.configuration.Range
import org.u2sa.interfaces.configuration.VariableDeclaration
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

/**
 * What a phone knows of its vehicle by its own sensors, in two messages, each once and at the time at which it was measured:
 * "… GPS" says where it is, "… attitude" how it lies and turns. Out: sensed-state. Thesis 4.6.3: the phone's sensors, before a
 * GPS and a compass joined the IOIO.
 *
 * The attitude waits for the first fix: magnetic north becomes true north by the place. The State Estimator joins the two,
 * and lets a fix drop out that has grown too old.
 */
class PhoneStateSensor(context: ServiceContext, private val sensors: PhoneSensors) :
    ProprioceptiveSensor(context, "PhoneSensor", STEPS_PER_S) {
    private val mounting = Mounting.valueOf(getVariable(MOUNTING))
    private val fixTimeoutMicros = Clock.micros(getVariable(FIX_TIMEOUT))
    private val attitudeTimeoutMicros = Clock.micros(getVariable(ATTITUDE_TIMEOUT))
    private val headingSigmaRad = getVariable(HEADING_SIGMA)
    private val gpsName = sensorName() + " GPS"
    private val attitudeName = sensorName() + " attitude"
    private var said = ""
    private var lastFix: GpsFix? = null // published
    private var lastOrientation: PhoneOrientation? = null // published

    override fun step(nowS: Double) {
        val reading = sensors.read()
        val now = clock().micros()
        report(trouble(reading, now))
        reading.fix
            ?.takeIf { it.valid() && now - it.measuredAtMicros() <= fixTimeoutMicros }
            ?.takeIf { it.measuredAtMicros() != lastFix?.measuredAtMicros() }
            ?.let {
                lastFix = it
                publish(Channels.SENSED_STATE, place(it, reading))
            }
        val here = lastFix ?: return
        reading.orientation
            ?.takeIf { now - it.measuredAtMicros <= attitudeTimeoutMicros }
            ?.takeIf { it.measuredAtMicros != lastOrientation?.measuredAtMicros }
            ?.let {
                lastOrientation = it
                publish(Channels.SENSED_STATE, attitude(it, here, reading))
            }
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
            log(if (trouble.isEmpty()) LogLevelEnum.INFO else LogLevelEnum.WARN, trouble.ifEmpty { "all sensors are there" })
        }
    }

    private fun measured(name: String, atMicros: Long): StateInformation {
        val state = StateInformation().sensorName(name).referenceFrame(ReferenceFrame.GLOBAL)
        state.timestamp(atMicros)
        return state
    }

    private fun place(fix: GpsFix, reading: PhoneSensors.Reading): StateInformation {
        val state = measured(gpsName, fix.measuredAtMicros())
        state.x(fix.longitudeDeg()).y(fix.latitudeDeg())
        fix.eastMps().ifPresent(state::xDot)
        fix.northMps().ifPresent(state::yDot)
        fix.upMps().ifPresent(state::zDot)
        fix.horizontalSigmaM().ifPresent { state.xSigma(it).ySigma(it) }
        altitude(fix, reading.pressure, state)
        return state
    }

    private fun attitude(orientation: PhoneOrientation, here: GpsFix, reading: PhoneSensors.Reading): StateInformation {
        val at = orientation.measuredAtMicros
        val declinationRad = MagneticModel.declinationRad(here.latitudeDeg(), here.longitudeDeg(), 0.0, year(at))
        val state = measured(attitudeName, at)
        val attitude = orientation.attitude(mounting)
        state.phi(attitude.phi).theta(attitude.theta).psi((attitude.psi + declinationRad).mod(2.0 * Math.PI))
        state.psiSigma(orientation.headingSigmaRad ?: headingSigmaRad)
        movement(orientation, reading, declinationRad, state)
        return state
    }

    private fun altitude(fix: GpsFix, pressure: PhoneSensors.Pressure?, state: StateInformation) {
        if (fix.altitudeM().isPresent) {
            state.z(fix.altitudeM().asDouble)
            fix.verticalSigmaM().ifPresent(state::zSigma)
        } else if (pressure != null) {
            state.z(Barometer.altitudeM(pressure.pascals)).zSigma(Barometer.SIGMA_M)
        }
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
            // at rest an accelerometer feels the ground push it up with one g
            state.xDoubleDot(trueEnu.x()).yDoubleDot(trueEnu.y()).zDoubleDot(trueEnu.z() - GRAVITY_MPS2)
        }
        reading.turnRate?.let { state.psiDot(-orientation.toEnu(it.vector).z()) } // psi grows clockwise, seen from above
    }

    /** A vector along magnetic east and north in true east and north. */
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
        private val MOUNTING: VariableDeclaration<String> = VariableDeclaration.text("MOUNTING")
            .oneOf(*Mounting.entries.map(Mounting::name).toTypedArray())
            .ifAbsent(Mounting.FLAT.name)
            .describedAs("How the phone is fixed: FLAT on its back, top edge forward; UPRIGHT or SIDEWAYS with its camera forward.")
        private val FIX_TIMEOUT: VariableDeclaration<Double> = VariableDeclaration.number("FIX TIMEOUT", "s")
            .range(Range.of(0.1, 60.0))
            .ifAbsent(2.5)
            .describedAs("Age at which a GPS fix counts as lost: it is not published, and the log says so.")
        private val ATTITUDE_TIMEOUT: VariableDeclaration<Double> = VariableDeclaration.number("ATTITUDE TIMEOUT", "s")
            .range(Range.of(0.1, 60.0))
            .ifAbsent(0.5)
            .describedAs("Age at which the phone's attitude counts as lost: it is not published, and the log says so.")
        private val HEADING_SIGMA: VariableDeclaration<Double> = VariableDeclaration.number("HEADING SIGMA", "rad")
            .range(Range.positive())
            .ifAbsent(0.17)
            .describedAs("Standard deviation of the heading where the phone does not say one.")

        private fun year(micros: Long) = EPOCH_YEAR + micros / MICROS_PER_YEAR
    }
}
