<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="editor.title" var="title"><fmt:param value="${floor}"/></fmt:message>
<fmt:message key="editor.canvas" var="canvasLabel"/>
<fmt:message key="editor.tools" var="toolsLabel"/>
<fmt:message key="map.zoomIn" var="zoomIn"/>
<fmt:message key="map.zoomOut" var="zoomOut"/>
<fmt:message key="map.fit" var="fit"/>
<fmt:message key="editor.undo" var="undo"/>
<fmt:message key="editor.redo" var="redo"/>
<fmt:message key="editor.approach.any" var="anyDirection"/>
<t:page title="${title}" here="floor" script="editor/editor.js" layout="live-map editor">
  <section class="map-panel">
    <div class="summary">
      <h1><bdi><c:out value="${title}"/></bdi></h1>
      <p id="save-state" class="age" role="status" data-state="none"></p>
      <div class="moment">
        <div class="zoom">
          <button type="button" id="undo" aria-label="${undo}" title="${undo}" disabled><t:icon name="undo"/></button>
          <button type="button" id="redo" aria-label="${redo}" title="${redo}" disabled><t:icon name="redo"/></button>
          <button type="button" id="zoom-in" aria-label="${zoomIn}" title="${zoomIn}">+</button>
          <button type="button" id="zoom-out" aria-label="${zoomOut}" title="${zoomOut}">−</button>
          <button type="button" id="zoom-fit" aria-label="${fit}" title="${fit}"><t:icon name="fit"/></button>
        </div>
      </div>
    </div>
    <noscript><p class="notice bad"><fmt:message key="editor.noscript"/></p></noscript>
    <p id="load-failed" class="notice bad" role="alert" hidden><fmt:message key="map.failed"/></p>
    <div class="drawing-tools" role="toolbar" aria-label="${toolsLabel}">
      <c:forTokens items="select,wall,line,rectangle,erase,eraseRectangle,keepOut,speedLimits,oneWay,freeZones,stations,parking,charging,measure" delims="," var="tool">
        <c:set var="icon" value="${tool == 'stations' ? 'legend-station' : tool == 'parking' or tool == 'charging' ? 'legend-'.concat(tool) : tool == 'measure' ? tool : 'tool-'.concat(tool)}"/>
        <button type="button" data-tool="${tool}" aria-pressed="false"><t:icon name="${icon}"/><span><fmt:message key="editor.tool.${tool}"/></span></button>
      </c:forTokens>
      <label id="brush-width-field" hidden><fmt:message key="editor.brushWidth"/> <input id="brush-width" inputmode="numeric" dir="ltr" value="1" size="3"></label>
      <label id="filled-field" hidden><input type="checkbox" id="filled"> <fmt:message key="editor.filled"/></label>
    </div>
    <div class="canvas">
      <canvas id="map" tabindex="0" role="application" aria-label="${canvasLabel}" aria-describedby="editor-keys" data-floor="${fn:escapeXml(floor)}"></canvas>
    </div>
    <p id="said" class="editor-said" role="status"></p>
  </section>
  <aside class="side-lists">
    <section id="selected" data-slowest="${slowest}" data-fastest="${fastest}" data-longest-name="${longestName}" hidden>
      <h2><span></span></h2>
      <p id="thing-error" class="fault" role="alert"></p>
      <div class="thing-fields">
        <label class="thing-field wide"><fmt:message key="editor.field.name"/><input data-field="name" dir="auto" autocomplete="off"></label>
        <label class="thing-field"><fmt:message key="editor.field.headingDegrees"/><input data-field="headingDegrees" placeholder="${anyDirection}" inputmode="decimal" dir="ltr" autocomplete="off"></label>
        <label class="thing-field"><fmt:message key="editor.field.approach"/><select data-field="approach"><option value=""><fmt:message key="editor.approach.any"/></option><c:forTokens items="east,north,west,south" delims="," var="way"><option value="${way}"><fmt:message key="editor.direction.${way}"/></option></c:forTokens></select></label>
        <label class="thing-field"><fmt:message key="editor.field.speed"/><input data-field="speed" inputmode="decimal" dir="ltr" autocomplete="off"></label>
        <label class="thing-field"><fmt:message key="editor.field.direction"/><select data-field="direction"><c:forTokens items="east,north,west,south" delims="," var="way"><option value="${way}"><fmt:message key="editor.direction.${way}"/></option></c:forTokens></select></label>
        <c:forTokens items="x,y,width,height" delims="," var="field"><label class="thing-field"><fmt:message key="editor.field.${field}"/><input data-field="${field}" inputmode="decimal" dir="ltr" autocomplete="off"></label></c:forTokens>
      </div>
      <button type="button" id="thing-delete" class="outline secondary wide"><fmt:message key="editor.remove"/></button>
    </section>
    <section class="publish">
      <div class="choices">
        <button type="button" id="publish"><fmt:message key="editor.publish"/></button>
        <button type="button" id="check" class="outline"><fmt:message key="editor.check"/></button>
        <button type="button" id="difference" class="outline" aria-pressed="false"><fmt:message key="editor.difference"/></button>
        <button type="button" id="discard" class="outline secondary"><fmt:message key="editor.discard"/></button>
      </div>
      <div id="problems" hidden>
        <p id="problems-summary"></p>
        <ul id="problem-list" class="things"></ul>
      </div>
      <div id="changes" hidden>
        <p id="changes-summary"></p>
        <ul class="legend"><li><span class="swatch added"></span><fmt:message key="editor.legend.added"/></li><li><span class="swatch removed"></span><fmt:message key="editor.legend.removed"/></li></ul>
        <ul id="change-list" class="things"></ul>
      </div>
    </section>
    <details open>
      <summary><fmt:message key="editor.things"/></summary>
      <p id="no-things" class="faint"><fmt:message key="editor.things.none"/></p>
      <ul id="things" class="things"></ul>
    </details>
    <details>
      <summary><fmt:message key="editor.resize"/></summary>
      <p id="size" class="faint"></p>
      <div class="thing-fields">
        <c:forTokens items="left,right,top,bottom" delims="," var="side"><label><fmt:message key="editor.resize.${side}"/><input id="resize-${side}" inputmode="numeric" dir="ltr" value="0" autocomplete="off"></label></c:forTokens>
      </div>
      <button type="button" id="resize" class="outline wide"><fmt:message key="editor.resize.submit"/></button>
      <p id="resize-said" class="faint" role="status"></p>
    </details>
    <details>
      <summary><fmt:message key="editor.moves"/></summary>
      <label><fmt:message key="editor.moves.choice"/><select id="moves" aria-describedby="moves-hint" autocomplete="off" disabled><c:forTokens items="heading,smooth" delims="," var="moves"><option value="${moves}"><fmt:message key="editor.moves.${moves}"/></option></c:forTokens></select></label>
      <small id="moves-hint" class="faint"><fmt:message key="editor.moves.hint"/></small>
    </details>
    <details>
      <summary><fmt:message key="editor.files"/></summary>
      <label><fmt:message key="editor.import.file"/><input type="file" id="import-file" accept=".zip,.png,.map" aria-describedby="import-hint"></label>
      <small id="import-hint" class="faint"><fmt:message key="editor.import.hint"/></small>
      <div class="thing-fields">
        <label><fmt:message key="editor.import.resolution"/><input id="import-resolution" inputmode="decimal" dir="ltr" value="0.05" autocomplete="off"></label>
        <label><fmt:message key="editor.import.threshold"/><input id="import-threshold" inputmode="decimal" dir="ltr" value="50" autocomplete="off"></label>
      </div>
      <button type="button" id="import" class="outline wide"><fmt:message key="editor.import.submit"/></button>
      <p id="import-said" class="faint" role="status"></p>
      <p><fmt:message key="editor.export"/><br>
        <a href="<c:out value="${root}/api/v1/floors/${segment}/export?format=ros"/>" download><fmt:message key="floors.export.ros"/></a><br>
        <a href="<c:out value="${root}/api/v1/floors/${segment}/export?format=movingai"/>" download><fmt:message key="floors.export.movingai"/></a></p>
    </details>
    <details>
      <summary><fmt:message key="editor.keys"/></summary>
      <p id="editor-keys" class="faint"><fmt:message key="editor.keys.text"/></p>
    </details>
  </aside>
  <dialog id="publishing" aria-labelledby="publishing-title">
    <article>
      <h2 id="publishing-title"><fmt:message key="editor.publish.title"/></h2>
      <p id="publish-changes"></p>
      <p><fmt:message key="editor.publish.follows"/></p>
      <p id="publish-warnings" class="notice warn" hidden><fmt:message key="editor.publish.warnings"/></p>
      <div class="choices">
        <button type="button" id="publish-sure"><fmt:message key="editor.publish.submit"/></button>
        <button type="button" class="outline" data-close><fmt:message key="common.cancel"/></button>
      </div>
    </article>
  </dialog>
  <dialog id="discarding" aria-labelledby="discarding-title">
    <article>
      <h2 id="discarding-title"><fmt:message key="editor.discard"/></h2>
      <p><fmt:message key="editor.discard.sure"/></p>
      <div class="choices">
        <button type="button" id="discard-sure" class="danger"><fmt:message key="editor.discard"/></button>
        <button type="button" class="outline" data-close><fmt:message key="common.cancel"/></button>
      </div>
    </article>
  </dialog>
  <dialog id="conflict" aria-labelledby="conflict-title">
    <article>
      <h2 id="conflict-title"><fmt:message key="editor.conflict"/></h2>
      <p id="conflict-who"></p>
      <p><fmt:message key="editor.conflict.choose"/></p>
      <div class="choices">
        <button type="button" id="conflict-load"><fmt:message key="editor.conflict.load"/></button>
        <button type="button" id="conflict-keep" class="outline"><fmt:message key="editor.conflict.keep"/></button>
      </div>
    </article>
  </dialog>
  <c:set var="kinds" value=""/>
  <c:forTokens items="stations,parking,charging,keepOut,speedLimits,oneWay,freeZones" delims="," var="kind"><c:set var="kinds" value="${kinds} editor.kind.${kind}"/></c:forTokens>
  <t:texts keys="map.loggedOut common.comma editor.away editor.unsaved editor.state.none editor.state.saved editor.state.saving editor.state.conflict editor.said.walls editor.said.free editor.said.moved editor.said.measured editor.said.selected editor.said.added editor.said.removed editor.said.undo editor.said.redo editor.said.begun editor.said.cancelled map.speedLimit editor.error.number editor.error.name editor.error.nameTwice editor.checking editor.noProblems editor.changedMeanwhile editor.problems.count editor.problems.outdated editor.problem.blocking editor.problem.warning editor.publish.unsaved editor.published editor.discarded editor.changes editor.changes.none editor.changes.otherGrid editor.changes.moves editor.said.moves editor.moves.heading editor.moves.smooth editor.change.added editor.change.removed editor.change.changed editor.import.choose editor.import.reading editor.import.done editor.resize.wrong editor.resize.done editor.newName.stations editor.newName.parking editor.newName.charging editor.describe.place editor.describe.area editor.cell editor.cell.wall editor.cell.free editor.size loads.size common.position editor.conflict.changed editor.conflict.gone editor.conflict.loaded editor.conflict.kept${kinds}"/>
</t:page>
