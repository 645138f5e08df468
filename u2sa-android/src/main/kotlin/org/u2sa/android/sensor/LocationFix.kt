package org.u2sa.android.sensor

import android.location.Location
import android.os.Build
import java.util.OptionalDouble
import kotlin.math.cos
import kotlin.math.sin
import org.u2sa.device.port.GpsFix

/** Android reports the 68 % radius; for a circular normal distribution that is 1.51 σ per axis. */
private const val RADIUS_68_PERCENT = 1.51

/** Converts an Android location to a fix measured at [measuredAtMicros] of the run's clock. */
internal fun fixOf(location: Location, measuredAtMicros: Long): GpsFix {
    val moves = location.hasSpeed() && (location.hasBearing() || location.speed == 0.0f)
    val speed = location.speed.toDouble()
    val course = Math.toRadians(location.bearing.toDouble())
    return GpsFix(
        measuredAtMicros,
        location.latitude,
        location.longitude,
        altitudeAboveSea(location),
        present(moves, speed * sin(course)),
        present(moves, speed * cos(course)),
        OptionalDouble.empty(),
        present(location.hasAccuracy(), location.accuracy / RADIUS_68_PERCENT),
        altitudeSigma(location),
        location.extras?.getInt("satellites", 0) ?: 0,
        location.latitude in -90.0..90.0 && location.longitude in -180.0..180.0,
    )
}

/** Android's older altitude is ellipsoidal, up to 100 m off mean sea level, so it is not used. */
private fun altitudeAboveSea(location: Location): OptionalDouble =
    if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.UPSIDE_DOWN_CAKE && location.hasMslAltitude()) {
        OptionalDouble.of(location.mslAltitudeMeters)
    } else {
        OptionalDouble.empty()
    }

private fun altitudeSigma(location: Location): OptionalDouble =
    if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.UPSIDE_DOWN_CAKE && location.hasMslAltitudeAccuracy()) {
        OptionalDouble.of(location.mslAltitudeAccuracyMeters.toDouble())
    } else {
        OptionalDouble.empty()
    }

private fun present(there: Boolean, value: Double): OptionalDouble =
    if (there && value.isFinite()) OptionalDouble.of(value) else OptionalDouble.empty()
