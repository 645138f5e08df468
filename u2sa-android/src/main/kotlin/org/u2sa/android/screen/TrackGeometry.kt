package org.u2sa.android.screen

import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.min
import kotlin.math.pow
import org.u2sa.android.vehicle.VehicleSnapshot
import org.u2sa.messages.frame.Geodetic

private const val MIN_EXTENT_M = 20.0
private const val SCALE_BAR_PART = 0.3

/** Maps a snapshot to an image, north up, so that everything fits with a margin. */
internal class TrackGeometry(snapshot: VehicleSnapshot, private val width: Double, private val height: Double, margin: Double) {
    private val places = snapshot.track + snapshot.goals.map { it.place } + listOfNotNull(snapshot.motion?.place)
    private val origin: Geodetic? = places.firstOrNull()
    private val flat = places.map { origin!!.enuOf(it) }
    private val west = flat.minOfOrNull { it.x() } ?: 0.0
    private val east = flat.maxOfOrNull { it.x() } ?: 0.0
    private val south = flat.minOfOrNull { it.y() } ?: 0.0
    private val north = flat.maxOfOrNull { it.y() } ?: 0.0

    /** Scale [px/m]. */
    val pixelsPerMetre: Double = min(
        (width - 2.0 * margin) / maxOf(east - west, MIN_EXTENT_M),
        (height - 2.0 * margin) / maxOf(north - south, MIN_EXTENT_M),
    ).coerceAtLeast(0.0)

    /** Whether there is anything to draw. */
    val isEmpty: Boolean get() = origin == null

    /** Pixel coordinates, right and down from the top left corner. */
    fun pixels(place: Geodetic): Pair<Float, Float> {
        val enu = requireNotNull(origin) { "nothing is drawn" }.enuOf(place)
        val x = width / 2.0 + (enu.x() - (west + east) / 2.0) * pixelsPerMetre
        val y = height / 2.0 - (enu.y() - (south + north) / 2.0) * pixelsPerMetre
        return Pair(x.toFloat(), y.toFloat())
    }

    /** Length of the scale bar [m]: 1, 2 or 5 times a power of ten. */
    fun scaleBarM(): Double {
        val longest = SCALE_BAR_PART * width / pixelsPerMetre
        val power = 10.0.pow(floor(log10(longest)))
        return listOf(5.0, 2.0, 1.0).first { it * power <= longest } * power
    }
}
