package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.content.Context
import android.graphics.Canvas
import android.graphics.Paint
import android.graphics.Path
import android.view.View
import kotlin.math.cos
import kotlin.math.sin
import org.u2sa.android.vehicle.VehicleSnapshot

private const val MARGIN_DP = 28f
private const val ARROW_DP = 14f
private const val GOAL_DP = 6f
private const val LINE_DP = 2f
private const val TEXT_SP = 13f

/** Draws track, position, heading and waypoints without a background map; north is up. */
class TrackView(context: Context) : View(context) {
    private val palette = Palette(context)
    private val dp = resources.displayMetrics.density
    private val line = Paint(Paint.ANTI_ALIAS_FLAG).apply {
        style = Paint.Style.STROKE
        strokeWidth = LINE_DP * dp
        strokeJoin = Paint.Join.ROUND
    }
    private val fill = Paint(Paint.ANTI_ALIAS_FLAG)
    private val text = Paint(Paint.ANTI_ALIAS_FLAG).apply {
        color = palette.text
        textSize = TEXT_SP * resources.displayMetrics.scaledDensity()
    }
    private var snapshot = VehicleSnapshot()

    /** Shows a new snapshot and updates the accessibility description. */
    fun show(next: VehicleSnapshot) {
        if (next.track != snapshot.track || next.motion != snapshot.motion || next.goals != snapshot.goals) {
            snapshot = next
            contentDescription = Wording(context).track(next)
            invalidate()
        }
    }

    /** Uses the imposed height, or the minimum height when free to choose, as in a scroll view. */
    override fun onMeasure(widthSpec: Int, heightSpec: Int) = setMeasuredDimension(
        getDefaultSize(suggestedMinimumWidth, widthSpec),
        if (MeasureSpec.getMode(heightSpec) == MeasureSpec.EXACTLY) MeasureSpec.getSize(heightSpec) else suggestedMinimumHeight,
    )

    override fun onDraw(canvas: Canvas) {
        val geometry = TrackGeometry(snapshot, width.toDouble(), height.toDouble(), (MARGIN_DP * dp).toDouble())
        if (geometry.isEmpty || geometry.pixelsPerMetre <= 0.0) {
            text.textAlign = Paint.Align.CENTER
            canvas.drawText(Text.TRACK_NONE.of(context), width / 2f, height / 2f, text)
            return
        }
        drawGoals(canvas, geometry)
        drawTrack(canvas, geometry)
        drawVehicle(canvas, geometry)
        drawFurniture(canvas, geometry)
    }

    private fun drawTrack(canvas: Canvas, geometry: TrackGeometry) {
        val path = Path()
        snapshot.track.forEachIndexed { i, place ->
            val (x, y) = geometry.pixels(place)
            if (i == 0) path.moveTo(x, y) else path.lineTo(x, y)
        }
        line.color = palette.track
        canvas.drawPath(path, line)
    }

    private fun drawGoals(canvas: Canvas, geometry: TrackGeometry) {
        text.textAlign = Paint.Align.LEFT
        for (goal in snapshot.goals.asReversed()) { // draw the current one on top
            val (x, y) = geometry.pixels(goal.place)
            line.color = palette.goal
            fill.color = palette.goal
            canvas.drawCircle(x, y, GOAL_DP * dp, if (goal.current) fill else line)
            canvas.drawText(goal.name, x + 1.5f * GOAL_DP * dp, y - GOAL_DP * dp, text)
        }
    }

    private fun drawVehicle(canvas: Canvas, geometry: TrackGeometry) {
        val motion = snapshot.motion ?: return
        val (x, y) = geometry.pixels(motion.place)
        fill.color = palette.vehicle
        if (motion.headingRad == null) {
            canvas.drawCircle(x, y, ARROW_DP * dp / 2f, fill)
            return
        }
        val arrow = Path()
        for ((i, corner) in ARROW.withIndex()) {
            val angle = motion.headingRad + corner.first
            val cornerX = x + (corner.second * ARROW_DP * dp * sin(angle)).toFloat()
            val cornerY = y - (corner.second * ARROW_DP * dp * cos(angle)).toFloat()
            if (i == 0) arrow.moveTo(cornerX, cornerY) else arrow.lineTo(cornerX, cornerY)
        }
        arrow.close()
        canvas.drawPath(arrow, fill)
    }

    private fun drawFurniture(canvas: Canvas, geometry: TrackGeometry) {
        line.color = palette.text
        val metres = geometry.scaleBarM()
        val left = MARGIN_DP * dp / 2f
        val bottom = height - MARGIN_DP * dp / 2f
        canvas.drawLine(left, bottom, left + (metres * geometry.pixelsPerMetre).toFloat(), bottom, line)
        text.textAlign = Paint.Align.LEFT
        canvas.drawText(Wording(context).metres(metres), left, bottom - 4f * dp, text)
        text.textAlign = Paint.Align.CENTER
        val right = width - MARGIN_DP * dp
        canvas.drawText(Text.NORTH.of(context), right, MARGIN_DP * dp, text)
        canvas.drawLine(right, MARGIN_DP * dp * 1.2f, right, MARGIN_DP * dp * 2f, line)
    }

    private companion object {
        /** Arrow corners: angle from the heading [rad] and distance from the centre. */
        val ARROW = listOf(0.0 to 1.0, 2.5 to 0.8, Math.PI to 0.3, -2.5 to 0.8)
    }
}
