<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="laboratory.title" var="title"/>
<t:page title="${title}" here="laboratory" script="laboratory/laboratory.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="laboratory.intro"><fmt:param value="${mostKept}"/></fmt:message></p>
    </div>
    <div class="choices"><a href="#runs"><fmt:message key="laboratory.results"/></a></div>
  </div>
  <t:errors/>
  <c:if test="${param.done == 'deleted'}"><p class="notice good" role="status"><fmt:message key="laboratory.done.deleted"/></p></c:if>
  <h2 id="experiments"><fmt:message key="laboratory.experiments"/></h2>
  <div class="experiments">
    <c:forEach items="${experiments}" var="experiment">
      <c:set var="sent" value="${not empty errors and param.experiment == experiment.name()}"/>
      <fmt:message key="laboratory.experiment.${experiment.name()}" var="sentence"/>
      <article class="experiment" id="${experiment.name()}">
        <h3><t:english text="${experiment.name()}"/></h3>
        <p><c:choose><c:when test="${fn:startsWith(sentence, '???')}"><t:english text="${experiment.title()}"/></c:when><c:otherwise><c:out value="${sentence}"/></c:otherwise></c:choose></p>
        <p class="faint"><t:english text="${experiment.source()}"/></p>
        <c:if test="${not caller.isVisitor()}">
          <details ${sent ? 'open' : ''}>
            <summary role="button" class="outline"><fmt:message key="laboratory.start"/></summary>
            <form method="post" action="${root}/laboratory#${experiment.name()}" novalidate>
              <t:csrf/>
              <input type="hidden" name="experiment" value="${experiment.name()}">
              <div class="numbers">
                <t:lab-number experiment="${experiment.name()}" name="seed" value="1" sent="${sent}" label="laboratory.seed"/>
                <t:lab-number experiment="${experiment.name()}" name="runs" value="1" sent="${sent}" label="laboratory.runs"/>
                <c:forEach items="${experiment.parameters()}" var="parameter">
                  <t:lab-number experiment="${experiment.name()}" name="parameter.${parameter.name()}" value="${parameter.value()}" sent="${sent}" meaning="${parameter.meaning()}" unit="${parameter.unit()}"/>
                </c:forEach>
              </div>
              <button><fmt:message key="laboratory.start.submit"/></button>
            </form>
          </details>
        </c:if>
      </article>
    </c:forEach>
  </div>
  <h2 id="runs"><fmt:message key="laboratory.results"/></h2>
  <c:if test="${empty runs}"><p class="notice"><fmt:message key="laboratory.empty"/></p></c:if>
  <c:if test="${not empty runs}">
    <form id="compare" method="get" action="${root}/laboratory/compare" class="filter"><button class="outline"><fmt:message key="laboratory.compare"/></button></form>
    <table class="stacks">
      <thead>
        <tr>
          <c:forTokens items="compare,id,experiment,seed,runs,user,ordered,state" delims="," var="column"><th scope="col"><fmt:message key="laboratory.column.${column}"/></th></c:forTokens>
        </tr>
      </thead>
      <tbody>
        <c:forEach items="${runs}" var="view">
          <c:set var="run" value="${view.run()}"/>
          <fmt:message key="laboratory.choose" var="choose"><fmt:param>${run.id()}</fmt:param></fmt:message>
          <tr data-run="${run.id()}" data-run-state="${run.state()}">
            <td><c:if test="${view.isDone()}"><input type="checkbox" name="run" value="${run.id()}" form="compare" aria-label="${choose}"></c:if></td>
            <td class="number"><a href="${root}/laboratory/runs/${run.id()}">${run.id()}</a></td>
            <th scope="row"><a href="${root}/laboratory/runs/${run.id()}"><t:english text="${run.order().experiment()}"/></a></th>
            <td data-label="<fmt:message key="laboratory.column.seed"/>"><bdi>${run.order().seed()}</bdi></td>
            <td data-label="<fmt:message key="laboratory.column.runs"/>"><bdi>${run.order().runs()}</bdi></td>
            <td data-label="<fmt:message key="laboratory.column.user"/>"><bdi><c:out value="${run.user()}"/></bdi></td>
            <td data-label="<fmt:message key="laboratory.column.ordered"/>"><t:time at="${run.orderedAt()}"/></td>
            <td class="whole"><t:lab-state view="${view}"/></td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
  </c:if>
</t:page>
