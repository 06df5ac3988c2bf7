<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="here" value="${root}/floors/${segment}/supervision"/>
<c:set var="run" value="${view.supervision()}"/>
<c:set var="runs" value="${not empty view and run.isRunning()}"/>
<c:url value="/map" var="mapUrl"><c:param name="floor" value="${floor}"/></c:url>
<fmt:message key="supervision.title" var="title"><fmt:param value="${floor}"/></fmt:message>
<t:page title="${title}" here="floor" script="shared/live.js">
  <div class="heading">
    <div>
      <h1><c:out value="${title}"/></h1>
      <p class="faint"><fmt:message key="supervision.intro"/>${" "}<t:help topic="supervision"/></p>
    </div>
    <div class="choices">
      <a href="<c:out value="${mapUrl}"/>"><fmt:message key="floors.map"/></a>
      <a href="${root}/floors"><fmt:message key="floors.title"/></a>
    </div>
  </div>
  <c:if test="${param.done == 'started' or param.done == 'stopped' or param.done == 'looks' or param.done == 'left-out'}"><p class="notice good" role="status"><fmt:message key="supervision.done.${param.done}"/></p></c:if>
  <c:forEach items="${refusals}" var="refusal"><p class="notice bad" role="alert"><c:out value="${refusal}"/></p></c:forEach>
  <div id="live" data-live="supervision" data-name="<c:out value="${floor}"/>">
    <c:if test="${empty view}"><p class="notice"><fmt:message key="supervision.none"/></p></c:if>
    <c:if test="${not empty view}">
      <c:if test="${not empty view.report() and not empty view.report().need()}">
        <div class="notice bad">
          <p><strong><fmt:message key="task.needsAttention"/></strong>${" "}<t:said sentence="${view.report().need()}"/></p>
          <c:if test="${view.isAnyLost() and caller.mayOperate()}"><form class="choices" method="post" action="<c:out value="${here}"/>/look"><t:csrf/><button class="outline"><fmt:message key="supervision.look"/></button></form></c:if>
        </div>
      </c:if>
      <p><span class="state" data-state="${run.state()}"><fmt:message key="supervision.state.${run.state()}"/></span><c:if test="${not empty view.report()}">${" "}<span id="doing"><t:said sentence="${view.report().doing()}"/></span></c:if></p>
      <dl class="facts">
        <div><dt><fmt:message key="supervision.delivered"/></dt><dd id="delivered"><fmt:message key="supervision.of"><fmt:param value="${run.deliveredCount()}"/><fmt:param value="${run.boxes().size()}"/></fmt:message></dd></div>
        <div><dt><fmt:message key="supervision.idle"/></dt><dd id="idle"><c:choose><c:when test="${run.idleSecondsPerBox().isPresent()}"><fmt:formatNumber value="${run.idleSecondsPerBox().get()}" maxFractionDigits="1" var="idle"/><fmt:message key="statistics.seconds"><fmt:param value="${idle}"/></fmt:message></c:when><c:otherwise><span class="faint"><fmt:message key="supervision.idle.none"/></span></c:otherwise></c:choose></dd></div>
        <div><dt><fmt:message key="supervision.order"/></dt><dd><fmt:message key="supervision.order.${run.overlaps() ? 'overlaps' : 'sequential'}"/></dd></div>
        <div><dt><fmt:message key="supervision.user"/></dt><dd><bdi><c:out value="${run.user()}"/></bdi></dd></div>
        <div><dt><fmt:message key="supervision.begun"/></dt><dd><t:time at="${run.begunAt()}"/></dd></div>
        <c:if test="${not empty run.endedAt()}"><div><dt><fmt:message key="supervision.ended"/></dt><dd><t:time at="${run.endedAt()}"/></dd></div></c:if>
      </dl>
      <h2><fmt:message key="supervision.robots"/></h2>
      <table class="stacks" id="robots">
        <thead><tr><c:forTokens items="robot,role,state,activity,battery,box" delims="," var="column"><th scope="col"><fmt:message key="supervision.column.${column}"/></th></c:forTokens></tr></thead>
        <tbody>
          <c:forEach items="${view.robots()}" var="robot">
            <c:url value="/robots/${robot.name()}" var="robotUrl"/>
            <tr>
              <th scope="row"><c:choose><c:when test="${empty robot.view()}"><bdi><c:out value="${robot.name()}"/></bdi></c:when><c:otherwise><a href="<c:out value="${robotUrl}"/>"><bdi><c:out value="${robot.name()}"/></bdi></a></c:otherwise></c:choose></th>
              <td data-label="<fmt:message key="supervision.column.role"/>"><fmt:message key="supervision.role.${robot.isSupervisor() ? 'supervisor' : 'worker'}"/></td>
              <td data-label="<fmt:message key="supervision.column.state"/>"><c:choose><c:when test="${empty robot.view()}"><span class="faint"><fmt:message key="supervision.robotGone"/></span></c:when><c:otherwise><t:state of="robot" state="${robot.view().state()}"/></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="supervision.column.activity"/>"><c:choose><c:when test="${empty robot.view()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><t:said sentence="${robot.view().work().doing()}"/></c:otherwise></c:choose></td>
              <td class="number" data-label="<fmt:message key="supervision.column.battery"/>"><c:choose><c:when test="${empty robot.view().telemetry().battery()}"><span class="faint"><fmt:message key="robot.battery.unknown"/></span></c:when><c:otherwise><fmt:formatNumber value="${robot.view().telemetry().battery()}" type="percent" maxFractionDigits="0"/></c:otherwise></c:choose></td>
              <td class="number" data-label="<fmt:message key="supervision.column.box"/>"><c:choose><c:when test="${empty robot.box()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise>${robot.box()}</c:otherwise></c:choose></td>
            </tr>
          </c:forEach>
        </tbody>
      </table>
      <h2><fmt:message key="supervision.boxes"/></h2>
      <table class="stacks" id="boxes">
        <thead><tr><c:forTokens items="box,boxState,weight,place,target,task,actions" delims="," var="column"><c:if test="${column != 'actions' or runs and caller.mayOperate()}"><th scope="col"><fmt:message key="supervision.column.${column}"/></th></c:if></c:forTokens></tr></thead>
        <tbody>
          <c:forEach items="${view.boxes()}" var="each">
            <c:set var="box" value="${each.box()}"/>
            <tr data-box="${box.number()}">
              <th scope="row" class="number"><span class="unseen"><fmt:message key="supervision.column.box"/>${" "}</span>${box.number()}</th>
              <td data-label="<fmt:message key="supervision.column.boxState"/>"><span><span class="state" data-state="${each.state()}"><fmt:message key="supervision.box.${each.state()}"/></span><c:if test="${not empty each.robots()}">${" "}<t:robots names="${each.robots()}"/></c:if>
                <c:if test="${not empty each.question()}"><br><strong><fmt:message key="task.needsAttention"/></strong>${" "}<t:said sentence="${each.question()}"/>${" "}<a href="${root}/tasks/${box.task()}#actions"><fmt:message key="task.toAnswers"/></a></c:if>
                <c:if test="${not empty each.reason()}"><br><small><t:said sentence="${each.reason()}"/></small></c:if></span></td>
              <td class="number" data-label="<fmt:message key="supervision.column.weight"/>"><c:choose><c:when test="${empty box.weight()}"><span class="faint"><fmt:message key="supervision.notWeighed"/></span></c:when><c:otherwise><fmt:formatNumber value="${box.weight()}" maxFractionDigits="2" var="weight"/><fmt:message key="common.kilograms"><fmt:param value="${weight}"/></fmt:message></c:otherwise></c:choose></td>
              <c:forTokens items="place,target" delims="," var="which">
                <c:set var="point" value="${which == 'place' ? (each.state() == 'CARRIED' ? null : box.place()) : box.target()}"/>
                <td class="number" data-label="<fmt:message key="supervision.column.${which}"/>"><c:choose><c:when test="${empty point}"><span class="faint"><fmt:message key="supervision.place.${each.state() == 'CARRIED' ? 'carried' : 'unknown'}"/></span></c:when><c:otherwise><fmt:formatNumber value="${point.x()}" maxFractionDigits="2" var="x"/><fmt:formatNumber value="${point.y()}" maxFractionDigits="2" var="y"/><bdi dir="ltr">(${x}, ${y})</bdi></c:otherwise></c:choose></td>
              </c:forTokens>
              <td class="number" data-label="<fmt:message key="supervision.column.task"/>"><c:choose><c:when test="${empty box.task()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><a href="${root}/tasks/${box.task()}">${box.task()}</a></c:otherwise></c:choose></td>
              <c:if test="${runs and caller.mayOperate()}">
                <td class="whole"><c:if test="${each.mayBeLeftOut()}">
                  <details>
                    <summary role="button" class="outline secondary"><fmt:message key="supervision.leaveOut"><fmt:param value="${box.number()}"/></fmt:message></summary>
                    <form method="post" action="<c:out value="${here}"/>/boxes/${box.number()}/leave-out"><t:csrf/><p><fmt:message key="supervision.leaveOut.sure"/></p><button class="danger"><fmt:message key="supervision.leaveOut.submit"><fmt:param value="${box.number()}"/></fmt:message></button></form>
                  </details>
                </c:if></td>
              </c:if>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </c:if>
    <c:if test="${runs and caller.mayManage()}">
      <details class="or">
        <summary role="button" class="outline secondary"><fmt:message key="supervision.stop"/></summary>
        <form method="post" action="<c:out value="${here}"/>/stop">
          <t:csrf/>
          <p><fmt:message key="supervision.stop.sure"/></p>
          <button class="danger"><fmt:message key="supervision.stop.submit"/></button>
        </form>
      </details>
    </c:if>
  </div>
  <c:if test="${not runs and caller.mayManage()}">
    <c:set var="sent" value="${not empty errors}"/>
    <c:set var="chosen" value="${sent ? param.supervisor : not empty view ? run.supervisor() : empty seeing ? '' : seeing[0]}"/>
    <article class="card" id="start">
      <h2><fmt:message key="supervision.start"/></h2>
      <t:errors/>
      <form method="post" action="<c:out value="${here}"/>" novalidate>
        <t:csrf/>
        <label for="supervisor"><fmt:message key="supervision.role.supervisor"/></label>
        <select id="supervisor" name="supervisor" aria-describedby="supervisor-help" ${empty errors.supervisor ? '' : 'aria-invalid="true"'}>
          <option value=""><fmt:message key="common.none"/></option>
          <c:forEach items="${candidates}" var="robot"><option value="<c:out value="${robot.name()}"/>" dir="auto" ${robot.name() == chosen ? 'selected' : ''}><c:out value="${robot.name()}"/></option></c:forEach>
        </select>
        <small id="supervisor-help"><c:choose><c:when test="${not empty errors.supervisor}"><bdi><c:out value="${errors.supervisor}"/></bdi></c:when><c:otherwise><fmt:message key="supervision.supervisor.hint"/></c:otherwise></c:choose></small>
        <fieldset aria-describedby="workers-help" ${empty errors.workers ? '' : 'aria-invalid="true"'}>
          <legend><fmt:message key="supervision.workers"/></legend>
          <c:forEach items="${candidates}" var="robot">
            <c:if test="${not empty robot.capabilities().arm()}">
              <c:set var="works" value="${not sent}"/>
              <c:forEach items="${paramValues.workers}" var="given"><c:if test="${given == robot.name()}"><c:set var="works" value="true"/></c:if></c:forEach>
              <label><input type="checkbox" name="workers" value="<c:out value="${robot.name()}"/>" ${works ? 'checked' : ''}> <bdi><c:out value="${robot.name()}"/></bdi></label>
            </c:if>
          </c:forEach>
          <small id="workers-help"><c:choose><c:when test="${not empty errors.workers}"><bdi><c:out value="${errors.workers}"/></bdi></c:when><c:otherwise><fmt:message key="supervision.workers.hint"/></c:otherwise></c:choose></small>
        </fieldset>
        <label for="boxTargets"><fmt:message key="supervision.targets"/></label>
        <textarea id="boxTargets" name="boxes" rows="6" dir="ltr" autocomplete="off" spellcheck="false" aria-describedby="boxes-help" ${empty errors.boxes ? '' : 'aria-invalid="true"'}><c:out value="${sent ? param.boxes : lastBoxes}"/></textarea>
        <small id="boxes-help"><c:choose><c:when test="${not empty errors.boxes}"><bdi><c:out value="${errors.boxes}"/></bdi></c:when><c:otherwise><fmt:message key="supervision.targets.hint"><fmt:param value="${mostBoxes}"/></fmt:message></c:otherwise></c:choose></small>
        <label><input type="checkbox" name="sequential" value="true" ${param.sequential == 'true' ? 'checked' : ''}> <fmt:message key="supervision.sequential"/></label>
        <button><fmt:message key="supervision.start.submit"/></button>
      </form>
    </article>
  </c:if>
</t:page>
